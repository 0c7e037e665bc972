// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/window_level.h"
#include "core/start/flow_hypotheses.h"
#include <pcl_msf/parameters.h>

#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief Poses of two frames that are worth descending from (section 3.3): the guess,
 * rest, what optical flow suggests; for segments that these leave unexplained, what the
 * flow of the depth images suggests. */
class PairStart {
public:
  /** \param scene of two frames; gets its links and brightness change */
  PairStart (WindowScene& scene,
             const EnergyParameters& energy,
             const SolverParameters& solver);

  /** \param labels of the reference \param at their level
   * \param given poses that are kept, one per segment; optical flow then tells the
   * exposure and stays as evidence; empty = search \return per segment */
  std::vector<RigidPose>
  run (const cv::Mat& labels,
       int at,
       const RigidPose& guess,
       const std::vector<RigidPose>& given);

  /** \brief The flow that run () began with; empty without. */
  const CoarseFlow&
  opticalFlow () const
  {
    return optical_;
  }

  /** \brief In place of run (): poses that many segments share. */
  void
  setCommon (std::vector<RigidPose> poses)
  {
    common_ = std::move (poses);
  }

  /** \brief Links of the reference's segments; what run () begins with. */
  void
  linkSegments (const cv::Mat& labels, int at, const SegmentPixels& points);

  /** \brief Lets segments jump to poses that many share, and to their neighbours'. */
  void
  proposeAgain (const WindowLevel& level, std::vector<RigidPose>& poses) const;
  /** \brief The same for segments that do not fit the current frame. \return how many
   * jumps there were */
  int
  proposeToLost (const WindowLevel& level, std::vector<RigidPose>& poses) const;
  /** \brief The same for some segments. */
  int
  proposeTo (std::vector<char> segments,
             const WindowLevel& level,
             std::vector<RigidPose>& poses) const;

private:
  std::vector<char>
  unexplained (const DataTerm& probes, const std::vector<RigidPose>& poses) const;
  FlowHypotheses
  lift (const CoarseFlow& flow,
        int at,
        const RigidPose& guess,
        const SegmentPixels& points,
        const std::vector<char>& wanted) const;
  FlowHypotheses
  liftOptical (const CoarseFlow& optical,
               int at,
               const RigidPose& guess,
               SegmentPixels& points);
  void
  suggest (const DataTerm& probes,
           int at,
           const FlowHypotheses& from,
           std::vector<RigidPose>& poses);
  void
  suggestFarMotions (const CoarseFlow& optical,
                     int at,
                     const RigidPose& guess,
                     SegmentPixels& points,
                     DataTerm& probes,
                     std::vector<RigidPose>& poses);
  int
  propose (const DataTerm& probes,
           double focal_length,
           const FlowHypotheses& flow,
           double flow_worth,
           int rounds,
           std::vector<char> moving,
           std::vector<RigidPose>& poses) const;
  void
  compareExposure (const RigidPose& pose, int at, SegmentPixels& points);
  void
  changeBrightness (int at, SegmentPixels& points) const;
  FrameLevel
  comparable (FrameLevel level) const;
  double
  lostShare (const DataTerm& probes, const std::vector<RigidPose>& poses) const;
  bool
  followsFlow (const SampleTable& flow, const RigidPose& pose) const;

  WindowScene& scene_;
  const EnergyParameters& energy_;
  const SolverParameters& solver_;
  const RgbdFrame& reference_;
  const RgbdFrame& current_;
  std::vector<RigidPose> common_; ///< that every segment may try
  CoarseFlow optical_;
};

} // namespace pcl_msf
