// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/dense_points.h"
#include "core/dense_result.h"
#include "core/window_solve.h"

#include <algorithm>

/* The results of WindowSolve, at the level of its last round. */
namespace pcl_msf {

SceneFlow
WindowSolve::resultFor (int frame)
{
  const int pair = pairs_.fromReference (frame);
  const DataTerm& data = level_->data (pair);
  SceneFlow result;
  result.camera = frames_[pairs_.reference()].camera();
  result.labels = segments_.labels();
  fillSegments (data,
                scene_.links,
                state_.ofPair (pair),
                residualScale (energy_, data.pixels()),
                scene_.threads,
                result);
  fillPoints (
      data, frames_[frame].camera(), user_.blend_motions, scene_.threads, result);
  return result;
}

MultiframeSceneFlow
WindowSolve::finish()
{
  const double before = monitor_.seconds();
  level_->sweep (state_, DataTerm::Pass::Linearize); // bodies may have changed
  MultiframeSceneFlow result;
  result.reference = pairs_.reference();
  for (int f = 0; f < pairs_.frames(); ++f)
    result.frames.push_back (f == pairs_.reference() ? SceneFlow{} : resultFor (f));
  for (const int p : scene_.used) {
    PairMotion motion{pairs_[p].from, pairs_[p].to, {}};
    for (const int body : state_.body_of)
      motion.segments.push_back (state_.poses[p][body]);
    result.motions.push_back (std::move (motion));
  }
  report_.result_seconds = monitor_.seconds() - before;
  concludeReport (result);
  return result;
}

void
WindowSolve::concludeReport (MultiframeSceneFlow& result)
{
  report_.iterations = monitor_.iterations();
  report_.history = monitor_.history();
  report_.stop_reason = monitor_.stopReason();
  if (cancelled_)
    report_.stop_reason = StopReason::Cancelled;
  if (report_.stop_reason != StopReason::NotRun)
    report_.converged = false;
  else
    report_.stop_reason =
        report_.converged ? StopReason::Converged : StopReason::IterationLimit;
  for (int f = 0; f < pairs_.frames(); ++f) {
    const auto& segments = result.frames[f].segments;
    const bool determined =
        std::any_of (segments.begin(), segments.end(), [] (const SegmentMotion& s) {
          return s.status != MotionStatus::Undetermined;
        });
    if (determined || f == pairs_.reference())
      continue;
    report_.converged = false;
    const std::string to =
        isPair() ? "" : " to frame " + std::to_string (f) + " of the window";
    report_.message = "no segment's motion" + to +
                      " is determined: the scene shows too little texture and shape, "
                      "or the frames show different places";
  }
  for (SceneFlow& flow : result.frames)
    flow.report = report_;
}

} // namespace pcl_msf
