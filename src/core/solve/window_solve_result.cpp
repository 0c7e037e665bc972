// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/dense_points.h"
#include "core/result/dense_visibility.h"
#include "core/result/deviations.h"
#include "core/result/flow_refinement.h"
#include "core/result/input_resolution.h"
#include "core/result/outcome.h"
#include "core/result/pose_covariance.h"
#include "core/result/segment_results.h"
#include "core/solve/window_solve.h"

#include <cmath>

/* The results of WindowSolve, at the level of its last round. */
namespace pcl_msf {

SceneFlow
WindowSolve::resultFor (int frame)
{
  const int pair = pairs_.fromReference (frame);
  const DataTerm& data = level_->data (pair);
  const SegmentPixels& points = level_->wholeReference();
  SceneFlow result;
  result.camera = frames_[pairs_.reference()].camera();
  result.labels = segments_.labels();
  fillSegments (data,
                scene_.links,
                state_.ofPair (pair),
                residualScale (energy_, data.pixels()),
                scene_.tuning.result,
                scene_.threads,
                result);
  fillPoints (points,
              frames_[frame].camera(),
              user_.blend_motions,
              scene_.tuning.result.blend,
              scene_.threads,
              result);
  refine (frame, result);
  fillVisibility (
      points, data.image(), scene_.tuning.result.visibility, scene_.threads, result);
  fillConfidence (data, pair, frames_[frame].camera(), result);
  return result;
}

/** Lets images adapt the flow to a frame. Of two frames optical flow is there, for a
 * window it is made; where a motion is followed it would take too long. */
void
WindowSolve::refine (int frame, SceneFlow& result) const
{
  const RgbdFrame& reference = frames_[pairs_.reference()];
  const RefinementTuning& tuning = scene_.tuning.result.refinement;
  if (!dense_ || !user_.refine_flow || !reference.hasIntensity() ||
      !frames_[frame].hasIntensity())
    return;
  const cv::Mat mask = pointsToRefine (result, tuning, scene_.threads);
  if (mask.empty())
    return;
  CoarseFlow optical = pair_start_.opticalFlow();
  if (!isPair() && user_.flow_proposals)
    optical = estimateOpticalFlow (
        reference, frames_[frame], scene_.tuning.start.flow, scene_.threads);
  const BrightnessChange& change = scene_.change;
  const ComparedImages images{
      change.gain * comparableIntensity (scene_, pairs_.reference(), 0) +
          meanShare (scene_, 0) * change.offset,
      comparableIntensity (scene_, frame, 0),
      std::sqrt (2.0) * scene_.noise.intensity,
      optical.ofSize (result.labels.size())};
  refineFlow (images, frames_[frame].camera(), mask, tuning, scene_.threads, result);
}

void
WindowSolve::fillConfidence (const DataTerm& data,
                             int pair,
                             const PinholeCamera& camera,
                             SceneFlow& result) const
{
  const std::vector<Matrix6> covariances =
      fillInformation (data,
                       scene_.links,
                       state_.ofPair (pair),
                       residualScale (energy_, data.pixels()),
                       scene_.tuning.result.information,
                       scene_.threads,
                       result);
  if (!dense_)
    return;
  fillDeviations (level_->wholeReference(),
                  covariances,
                  camera,
                  scene_.noise.inverse_depth,
                  scene_.tuning.result.deviation,
                  scene_.threads,
                  result);
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
  report_.iterations = monitor_.iterations();
  report_.light_changed = scene_.change.local;
  report_.history = monitor_.history();
  conclude (cancelled_ ? StopReason::Cancelled : monitor_.stopReason(),
            judge (result),
            report_);
  finishImages (result);
  for (SceneFlow& flow : result.frames)
    flow.report = report_;
  tellEnd();
  return result;
}

/** How well the motion into each frame fits. */
std::vector<Judgement>
WindowSolve::judge (MultiframeSceneFlow& result) const
{
  const int reference = pairs_.reference();
  std::vector<Judgement> judgements;
  for (int f = 0; f < pairs_.frames(); ++f) {
    if (f == reference)
      continue;
    judgements.push_back (judgeMotion (frames_[reference],
                                       frames_[f],
                                       scene_.noise.intensity,
                                       scene_.tuning.result.outcome,
                                       scene_.threads,
                                       result.frames[f]));
    judgements.back().frame = isPair() ? -1 : f;
  }
  return judgements;
}

/** Brings the images to the size of the input, or leaves them out. */
void
WindowSolve::finishImages (MultiframeSceneFlow& result)
{
  const RgbdFrame& reference = frames_[pairs_.reference()];
  const double before = monitor_.seconds();
  for (int f = 0; f < pairs_.frames(); ++f) {
    SceneFlow& flow = result.frames[f];
    if (!dense_)
      for (cv::Mat* image : {&flow.labels,
                             &flow.points,
                             &flow.displacement,
                             &flow.flow,
                             &flow.visibility})
        image->release();
    else if (f != pairs_.reference() && reference.finestLevel() > 0)
      carryToInput (reference,
                    frames_[f].inputCamera(),
                    scene_.tuning.frame,
                    scene_.threads,
                    flow);
  }
  report_.result_seconds += monitor_.seconds() - before;
}

/** Tells the callback that all is done; not one that has cancelled. */
void
WindowSolve::tellEnd() const
{
  if (cancelled_ || !user_.progress)
    return;
  Progress progress;
  progress.iteration = report_.iterations;
  progress.fraction = 1.0;
  progress.cost = report_.final_cost.total();
  progress.stage = "result";
  user_.progress (progress); // nothing is left to cancel
}

} // namespace pcl_msf
