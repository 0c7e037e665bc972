// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/tuning/tuning.h"
#include "core/data/data_term.h"
#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"
#include "core/window/frame_pairs.h"
#include <pcl_msf/rgbd_frame.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief What is the same for all levels of a window of two or more frames. */
struct WindowScene {
  const std::vector<RgbdFrame>& frames;
  const FramePairs& pairs;
  int segments;
  int threads;
  Tuning tuning{};
  std::vector<int> used{};                  ///< pairs that take part, ascending
  std::vector<SegmentLink> links{};         ///< reference frame
  std::vector<Eigen::Vector3d> centroids{}; ///< per segment, reference frame
  NoiseModel noise{};
  /** Frames differ in exposure. Either the reference's points are brought to the other
   * frame's ... Where light changed, this tells it for all pairs. */
  BrightnessChange change{};
  /** ... or, as a window of several pairs needs it, all frames to the reference's: per
   * frame, its intensity from the reference's; empty leaves them as they are. */
  std::vector<BrightnessChange> exposure{};
  /** Pixels of level 0 over which brightness errs alike, as the solves of a window's
   * start told or level 1 of a pair, before means were left out; 1: not known. It says
   * less about local means than about contrast then. */
  double brightness_area{1.0};
  double falloff{0.0}; ///< of brightness towards the corners, see fitFalloff
  std::unique_ptr<FlowEvidence> flow{}; ///< of the only pair; or none
  cv::Mat fused_depth{}; ///< of the reference, level 0, see DepthFusion; or empty
};

/** \brief How points of a level are made. */
PointOptions
pointOptions (const WindowScene& scene, int level);

/** \brief What local means of intensity count at a level beside contrast, in [0, 1]:
 * all that errs alike over them makes them as unsure as whitened residuals have it, and
 * a change of light more. */
double
meanShare (const WindowScene& scene, int level);

/** \brief A sample of a level's points, for comparing poses. */
SegmentPixels
probePoints (const FrameLevel& level,
             const cv::Mat& labels,
             const WindowScene& scene,
             PointOptions options);

/** \brief A frame's intensity at a level as the scene's other frames' compare with it:
 * a window's in the reference's exposure, local contrast where light changed; a pair's
 * change is not in it. CV_32FC1; empty without intensity. */
cv::Mat
comparableIntensity (const WindowScene& scene, int frame, int level);

/** \brief What of a level depends on no poses, once segments have been carried. */
struct LevelPoints {
  std::vector<SegmentPixels> pixels;              ///< per frame, grouped by segment
  std::unique_ptr<SegmentPixels> whole;           ///< all of the reference's, where
                                                  ///< those are thinned and results
                                                  ///< are wanted
  SegmentPixels probes;                           ///< a sample of the reference's
  std::vector<std::unique_ptr<Texture>> textures; ///< per frame
  std::vector<cv::Mat> means; ///< per frame, of intensity, see LevelNeeds
};

/** \brief What is wanted of a level beside its solve. */
struct LevelNeeds {
  bool results{false}; ///< dense ones: all of the reference's points
  bool means{false};   ///< local means of intensity, to be left out later
};

/** \brief Prepares a level. Of the scene it reads the frames, exposures and fused
 * depth, but no noise: that of the options counts. \param labels per frame, of this
 * level; empty for frames that no pair starts from */
LevelPoints
prepareLevel (const WindowScene& scene,
              int level,
              const std::vector<cv::Mat>& labels,
              const PointOptions& options,
              const LevelNeeds& needs = {});

/** \brief Has local means of a pair's intensities count as the scene's area says, on a
 * level that was prepared with its means before that was known; the results' points
 * keep theirs. */
void
leaveMeansOut (const WindowScene& scene, int level, LevelPoints& points);

/** \brief One pyramid level of a window: every frame's points grouped by the segments
 * carried there, every frame's texture, shared by all pairs; a data term per pair. */
class WindowLevel {
public:
  WindowLevel (const WindowScene& scene,
               int level,
               LevelPoints points,
               const EnergyParameters& energy);
  /** \param labels as prepareLevel () takes them, with the scene's noise */
  WindowLevel (const WindowScene& scene,
               int level,
               const std::vector<cv::Mat>& labels,
               const EnergyParameters& energy)
  : WindowLevel (scene,
                 level,
                 prepareLevel (scene, level, labels, pointOptions (scene, level)),
                 energy)
  {}
  WindowLevel (const WindowLevel&) = delete;
  WindowLevel&
  operator= (const WindowLevel&) = delete;

  /** \brief The pairs that take part, ascending. */
  const std::vector<int>&
  used () const
  {
    return scene_.used;
  }
  /** \brief The data term of a used pair. */
  const DataTerm&
  data (int pair) const
  {
    return *data_[pair];
  }
  /** \brief A sample of the points of a pair from the reference, for comparing poses.
   */
  const DataTerm&
  probes (int pair) const
  {
    return *probe_data_[pair];
  }
  /** \brief The used pairs, as the steps that form bodies see them. */
  std::vector<PairTerms>
  terms () const;

  /** \brief Evaluates every used pair's data term at a state. */
  void
  sweep (const WindowState& state, DataTerm::Pass pass);

  /** \brief Keeps the sums of the last sweep; see DataTerm::rememberSums. */
  void
  rememberSums ();
  /** \brief Takes segments back to the sums that were kept. */
  void
  recallSums (const std::vector<int>& segments);
  /** \brief Lets the next sweep find the correspondences of segments taken back. */
  void
  completeSums ();

  /** \brief Weighs every frame's points of large bodies by how well they fit; see
   * body_noise.h. */
  void
  rescaleBodyNoise (const WindowState& state);

  /** \brief Weighs the residuals by the scene's correlation areas from the next sweep
   * on. */
  void
  reweigh ();

  double
  focalLength () const
  {
    return focal_length_;
  }
  const SegmentPixels&
  pixels (int frame) const
  {
    return points_.pixels[frame];
  }
  /** \brief All points of the reference, if results are wanted, else the solve's. What
   * these learnt of their noise is not in them. */
  const SegmentPixels&
  wholeReference () const
  {
    return points_.whole ? *points_.whole : pixels (scene_.pairs.reference());
  }

private:
  void
  setAreas ();

  const WindowScene& scene_;
  const EnergyParameters energy_;
  LevelPoints points_;
  std::vector<std::unique_ptr<DataTerm>> data_;       ///< per pair
  std::vector<std::unique_ptr<DataTerm>> probe_data_; ///< per pair
  double focal_length_;
};

} // namespace pcl_msf
