// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/stream_tracker.h"

#include "common/interruption.h"
#include "common/outcome_text.h"
#include <pcl_msf/errors.h>

namespace pcl_msf::tool {

namespace {

constexpr double kDegrees = 57.29577951308232; // per radian

TrackerParameters
trackerParameters (const PlayerSettings& options)
{
  TrackerParameters parameters;
  parameters.window = options.window;
  parameters.dense = options.dense;
  return parameters;
}

SolverParameters
interruptible (SolverParameters solver, const std::function<bool()>& go_on)
{
  solver.progress = [go_on] (const Progress&) { return !interrupted() && go_on(); };
  return solver;
}

} // namespace

StreamTracker::StreamTracker (const PlayerSettings& options,
                              const std::function<bool()>& go_on)
: tracker_ (trackerParameters (options),
            options.segmentation,
            options.energy,
            interruptible (options.solver, go_on),
            options.multiframe)
{}

StreamResult
StreamTracker::take (const StreamFrame& frame)
{
  StreamResult result;
  result.index = frame.index;
  result.problem = frame.problem;
  if (result.problem.empty())
    track (frame, result);
  const std::chrono::duration<double> latency = StreamClock::now() - frame.arrival;
  result.latency = latency.count();
  return result;
}

void
StreamTracker::track (const StreamFrame& frame, StreamResult& result)
{
  try {
    tracker_.add (frame.frame);
  }
  catch (const InvalidInput& e) {
    result.problem = e.what();
    return;
  }
  indices_[tracker_.frameIndex (tracker_.frames() - 1)] = frame.index;
  std::map<long, int> kept; // of frames that the tracker still has
  for (int f = 0; f < tracker_.frames(); ++f)
    kept[tracker_.frameIndex (f)] = indices_[tracker_.frameIndex (f)];
  indices_.swap (kept);
  result.reference = indices_.begin()->second;
  result.first = tracker_.frames() == 1;
  if (result.first)
    return;
  const SceneFlow& flow = tracker_.sceneFlow();
  result.cancelled = flow.report.stop_reason == StopReason::Cancelled;
  result.problem = problemOf (flow.report);
  result.groups = flow.groups;
  const auto& motion = flow.dominant_motion.parameters;
  result.degrees = kDegrees * Eigen::Vector3d (motion[0], motion[1], motion[2]).norm();
  result.metres = Eigen::Vector3d (motion[3], motion[4], motion[5]).norm();
  result.camera = tracker_.cameraPose();
}

} // namespace pcl_msf::tool
