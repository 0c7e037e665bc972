// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/player_settings.h"
#include "common/player/stream_frame.h"
#include <pcl_msf/scene_flow_tracker.h>

#include <functional>
#include <map>
#include <string>

namespace pcl_msf::tool {

/** \brief What the tracker found of one frame. */
struct StreamResult {
  int index{0};          ///< place in the recording
  int reference{0};      ///< of the frame whose points are followed
  std::string problem;   ///< why the frame is lost; empty when it is tracked
  bool first{false};     ///< of the stream: there is no motion yet
  bool cancelled{false}; ///< a signal came meanwhile: neither tracked nor lost
  int groups{0};         ///< that move together
  double metres{0.0};    ///< dominant motion since the reference: its translation
  double degrees{0.0};   ///< and its rotation
  RigidPose camera;      ///< `world_from_camera`, the world is the first frame's
  double latency{0.0};   ///< from the frame's arrival to this, seconds
};

/** \brief Follows frames with a SceneFlowTracker and survives those that it loses. */
class StreamTracker {
public:
  /** \param go_on asked after every iteration; false = the frame is not wanted any
   * more \throws InvalidInput */
  explicit StreamTracker (
      const PlayerSettings& options,
      const std::function<bool()>& go_on = [] { return true; });

  StreamResult
  take (const StreamFrame& frame);

  /** \brief From the reference to the frame taken last, when that is tracked. */
  const SceneFlow&
  sceneFlow () const
  {
    return tracker_.sceneFlow();
  }

private:
  void
  track (const StreamFrame& frame, StreamResult& result);

  SceneFlowTracker tracker_;
  std::map<long, int> indices_; ///< in the recording, by the tracker's, of the window
};

} // namespace pcl_msf::tool
