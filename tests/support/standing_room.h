// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/window_scene.h"

namespace pcl_msf::test {

/** The room with the box standing in it, seen by a moving camera; small motion. */
inline AnalyticScene
standingRoom ()
{
  AnalyticScene scene = roomWithBox();
  scene.motions[1] = scene.motions[0];
  return scene;
}

/** Of the camera of a frame, at a point in the middle of the room, metres. */
inline double
distanceToTruth (const AnalyticScene& scene, int frame, const RigidPose& found)
{
  const RigidPose truth = motionBetween (scene, 0, 0, frame).inverse();
  return (found * Eigen::Vector3d (0, 0, 2.5) - truth * Eigen::Vector3d (0, 0, 2.5))
      .norm();
}

} // namespace pcl_msf::test
