// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/data_term.h"
#include "core/frame_pairs.h"
#include "core/multi_frame_state.h"
#include <pcl_msf/rgbd_frame.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief What is the same for all levels of a window. */
struct MultiFrameScene {
  const std::vector<RgbdFrame>& frames;
  const FramePairs& pairs;
  std::vector<int> used;                  ///< pairs that take part, ascending
  std::vector<SegmentLink> links;         ///< reference frame
  std::vector<Eigen::Vector3d> centroids; ///< per segment, reference frame
  std::vector<BrightnessChange> exposure; ///< per frame: its intensity from the
                                          ///< reference's
  cv::Mat fused_depth; ///< of the reference, level 0; empty before fuseInverseDepth
  double falloff; ///< of the camera's brightness towards the corners, see fitFalloff
  NoiseModel noise;
  int segments;
  int threads;
};

/** \brief One pyramid level of a window: every frame's points grouped by the segments
 * carried there, every frame's texture, shared by all pairs; a data term per pair.
 *
 * Intensities are brought to the reference's exposure, so that points and textures fit
 * every pair. */
class MultiFrameLevel {
public:
  /** \param labels per frame, of this level; empty for frames that no pair starts from
   */
  MultiFrameLevel (const MultiFrameScene& scene,
                   int level,
                   const std::vector<cv::Mat>& labels,
                   const EnergyParameters& energy,
                   double relative_tolerance);
  MultiFrameLevel (const MultiFrameLevel&) = delete;
  MultiFrameLevel&
  operator= (const MultiFrameLevel&) = delete;

  /** \brief The data term of a used pair. */
  DataTerm&
  data (int pair)
  {
    return *data_[pair];
  }
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

  /** \brief Evaluates every used pair's data term at a state. */
  void
  sweep (const MultiFrameState& state, DataTerm::Pass pass);

  /** \brief Weighs every frame's points of large bodies by how well they fit; see
   * body_noise.h. */
  void
  sharpenRigidBodies (const MultiFrameState& state);

  double
  focalLength () const
  {
    return focal_length_;
  }
  const SegmentPixels&
  pixels (int frame) const
  {
    return pixels_[frame];
  }

private:
  const MultiFrameScene& scene_;
  std::vector<SegmentPixels> pixels_;                 ///< per frame
  SegmentPixels probes_;                              ///< of the reference
  std::vector<std::unique_ptr<Texture>> textures_;    ///< per frame
  std::vector<std::unique_ptr<DataTerm>> data_;       ///< per pair
  std::vector<std::unique_ptr<DataTerm>> probe_data_; ///< per pair
  double focal_length_;
};

} // namespace pcl_msf
