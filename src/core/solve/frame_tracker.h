// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow_tracker.h>

#include <deque>
#include <memory>
#include <vector>

namespace pcl_msf {

struct FollowedMotion;
class WindowSolve;

/** \brief What SceneFlowTracker is made of; its functions are told there. */
class FrameTracker {
public:
  FrameTracker() = default;
  FrameTracker (const TrackerParameters& tracker,
                const SegmentationParameters& segmentation,
                const EnergyParameters& energy,
                const SolverParameters& solver,
                const MultiframeParameters& multiframe);

  void
  add (const RgbdFrame& frame);
  void
  reset ();

  int
  frames () const
  {
    return static_cast<int> (frames_.size());
  }
  const std::vector<long>&
  indices () const
  {
    return indices_;
  }
  const MultiframeSceneFlow&
  result () const
  {
    return result_;
  }
  const SceneFlow&
  sceneFlow () const;
  const Oversegmentation&
  segments () const
  {
    return segments_;
  }
  RigidPose
  cameraPose () const;

private:
  /** What is solved next. */
  struct Window {
    std::deque<RgbdFrame> frames;
    std::vector<long> indices; ///< per frame
    std::vector<int>
        former; ///< per frame but the new one, its place in the former window
    Oversegmentation segments;
    std::vector<int> origin; ///< per segment, its number in the former window or -1
    RigidPose world_from_reference;
  };
  struct Following;

  Window
  grow () const;
  Window
  slide () const;
  Window
  beginAnew () const;
  std::vector<int>
  mergedLabels () const;
  void
  solve (Window window);
  void
  follow (Window window);
  std::shared_ptr<Following>
  learn (const WindowSolve& solve, const Window& window) const;
  FollowedMotion
  predictMotion () const;
  FollowedMotion
  predictAnew (const Oversegmentation& segments) const;
  void
  adopt (Window window, MultiframeSceneFlow result);
  double
  visibleShare () const;
  void
  requireValid () const;

  TrackerParameters tracker_;
  SegmentationParameters segmentation_;
  EnergyParameters energy_;
  SolverParameters solver_;
  MultiframeParameters multiframe_;
  std::deque<RgbdFrame> frames_;
  Oversegmentation segments_;
  MultiframeSceneFlow result_;
  RigidPose world_from_reference_;
  std::vector<long> indices_;                  ///< per frame of the window
  std::shared_ptr<const Following> following_; ///< null: the next frame is looked for
  bool explained_{true};                       ///< the newest frame, by the reference
};

} // namespace pcl_msf
