// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/standing_room.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/scene_flow_tracker.h>

#include <string>
#include <utility>

/* Trackers as objects: what they say without frames, and after they were moved from. */
namespace {

using namespace pcl_msf;
using ::testing::HasSubstr;

std::string
messageOf (const SceneFlowTracker& tracker, int frame)
{
  try {
    tracker.frameIndex (frame);
  }
  catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

TEST (TrackerObjects, AFreshOneHasAReportAndNoFrames)
{
  const SceneFlowTracker tracker;
  EXPECT_EQ (tracker.result().report().stop_reason, StopReason::NotRun);
  EXPECT_FALSE (tracker.result().report().converged);
  EXPECT_EQ (tracker.firstFrame(), 0);
  EXPECT_THAT (messageOf (tracker, 0),
               HasSubstr ("there is no frame 0 in a window of 0"));
}

TEST (TrackerObjects, OneThatWasMovedFromBeginsAnew)
{
  const test::AnalyticScene scene = test::standingRoom();
  SceneFlowTracker tracker;
  for (const test::View& view : test::renderWindow (scene, 2))
    tracker.add (scene.frame (view));
  EXPECT_EQ (tracker.frameIndex (1), 1);
  EXPECT_THAT (messageOf (tracker, 2), HasSubstr ("no frame 2 in a window of 2"));
  EXPECT_THAT (messageOf (tracker, -1), HasSubstr ("give 0 to"));
  const auto pose = tracker.cameraPose().parameters;

  SceneFlowTracker moved (std::move (tracker));
  EXPECT_EQ (moved.cameraPose().parameters, pose);
  SceneFlowTracker& empty = tracker; // that it may be used is the point
  EXPECT_EQ (empty.frames(), 0);
  EXPECT_TRUE (empty.result().frames.empty());
  EXPECT_EQ (empty.cameraPose().parameters, RigidPose().parameters);

  empty = std::move (moved);
  EXPECT_EQ (empty.cameraPose().parameters, pose);
  EXPECT_EQ (moved.frames(), 0);
  SceneFlowTracker& itself = empty;
  empty = std::move (itself);
  EXPECT_EQ (empty.frames(), 2);
  moved.add (scene.frame (scene.render (false)));
  EXPECT_EQ (moved.frames(), 1);
}

} // namespace
