// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/flow_hypotheses.h"
#include "core/minimize.h"
#include "core/window_level.h"
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief One two-frame estimation, from start to result: section 3 in order.
 *
 * start () finds poses worth descending from; refine () minimizes Eq. 5 from the
 * coarsest level used to the finest; finish () writes down the result.
 */
class TwoFrameSolve {
public:
  TwoFrameSolve (const RgbdFrame& reference,
                 const RgbdFrame& current,
                 const Oversegmentation& segments,
                 const EnergyParameters& energy,
                 const SolverParameters& solver);

  SceneFlow
  run (const RigidPose& guess);

  /** \brief Has run () begin at these poses, one per segment, without looking for
   * better ones; optical flow then tells the exposure alone. */
  void
  startFrom (const std::vector<RigidPose>& poses)
  {
    given_start_ = poses;
  }

  /** \brief start () and refine () down to a level, without a result: what a window of
   * more frames begins with. */
  void
  solve (const RigidPose& guess, int finest_level);

  const WindowState&
  state () const
  {
    return state_;
  }
  const std::vector<SegmentLink>&
  links () const
  {
    return scene_.links;
  }
  const NoiseModel&
  noise () const
  {
    return scene_.noise;
  }
  const BrightnessChange&
  brightnessChange () const
  {
    return scene_.change;
  }
  const SolveMonitor&
  monitor () const
  {
    return monitor_;
  }

private:
  void
  prepare ();
  void
  start (const RigidPose& guess);
  void
  propose (const DataTerm& probes,
           double focal_length,
           const FlowHypotheses& flow,
           int rounds);
  std::vector<char>
  unexplained (const DataTerm& probes) const;
  void
  refine (int level);
  void
  finishBodies ();
  void
  minimize (int iterations);
  void
  merge ();
  void
  finish (SceneFlow& result);
  void
  concludeReport (SceneFlow& result);

  const std::vector<RgbdFrame> frames_; ///< reference and current
  const FramePairs pairs_{2, 0};
  const Oversegmentation& segments_;
  const EnergyParameters energy_;
  const SolverParameters solver_;
  const int levels_;
  SolveMonitor monitor_;
  std::vector<cv::Mat> labels_; ///< per level
  WindowScene scene_;
  WindowState state_;
  std::vector<RigidPose> common_poses_; ///< that every segment may try
  std::vector<RigidPose> given_start_;  ///< in place of a search; empty = search
  std::unique_ptr<WindowLevel> level_;  ///< the present one
  Report report_;
};

} // namespace pcl_msf
