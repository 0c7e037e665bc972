// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/dense_points.h"
#include "core/dense_result.h"
#include "core/dense_visibility.h"
#include "core/multi_frame_solve.h"
#include "core/outcome.h"

/* The results of MultiFrameSolve, from its last round. */
namespace pcl_msf {

SceneFlow
MultiFrameSolve::resultFor (int frame)
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
  fillVisibility (data, scene_.threads, result);
  return result;
}

MultiframeSceneFlow
MultiFrameSolve::finish()
{
  const double before = monitor_.seconds();
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
MultiFrameSolve::concludeReport (MultiframeSceneFlow& result)
{
  report_.iterations = monitor_.iterations();
  report_.history = monitor_.history();
  const RgbdFrame& reference = frames_[pairs_.reference()];
  std::vector<Judgement> judgements;
  for (int f = 0; f < pairs_.frames(); ++f) {
    if (f == pairs_.reference())
      continue;
    judgements.push_back (
        judgeMotion (reference, frames_[f], scene_.noise.intensity, result.frames[f]));
    judgements.back().frame = f;
  }
  conclude (
      cancelled_ ? StopReason::Cancelled : monitor_.stopReason(), judgements, report_);
  for (SceneFlow& flow : result.frames)
    flow.report = report_;
}

} // namespace pcl_msf
