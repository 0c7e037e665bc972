// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "score_pair.h"

#include "common/depth_points.h"
#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/evaluation/motion_errors.h>
#include <pcl_msf/evaluation/residuals.h>
#include <pcl_msf/io/figures.h>
#include <pcl_msf/rgbd_frame.h>

#include <algorithm>

namespace pcl_msf::tool {

namespace {

using evaluation::ScoredPoints;

double
depthNoise (const io::RgbdImages& images)
{
  FrameParameters parameters;
  parameters.normals = NormalMethod::Skip;
  parameters.max_levels = 1;
  return RgbdFrame::fromImages ({}, images.depth, images.camera, parameters)
      .inverseDepthNoise();
}

} // namespace

PairScorer::PairScorer (const PairData& pair)
: pair_ (pair)
, all_ (evaluation::scoredPoints (
      pair.reference.depth, pair.truth.visible, ScoredPoints::All))
, visible_ (evaluation::scoredPoints (
      pair.reference.depth, pair.truth.visible, ScoredPoints::Visible))
, occluded_ (evaluation::scoredPoints (
      pair.reference.depth, pair.truth.visible, ScoredPoints::Occluded))
, points_ (pointsOf (pair.reference))
, inverse_depth_noise_ (
      std::max (depthNoise (pair.reference), depthNoise (pair.current)))
{}

void
PairScorer::scoreFlow (const Estimate& estimate, Score& s) const
{
  if (pair_.truth.flow.empty())
    return;
  const cv::Mat& truth = pair_.truth.flow;
  const auto all = evaluation::flowErrors (estimate.flow, truth, all_);
  const auto seen = evaluation::flowErrors (estimate.flow, truth, visible_);
  const auto hidden = evaluation::flowErrors (estimate.flow, truth, occluded_);
  s.coverage = seen.coverage;
  s.epe_all = all.epe;
  s.epe_visible = seen.epe;
  s.epe_occluded = hidden.epe;
  s.epe_median = seen.median;
  s.rms_all = all.rms;
  s.rms_visible = seen.rms;
  s.rms_occluded = hidden.rms;
  s.aae_all = all.angle;
  s.aae_visible = seen.angle;
  s.aae_occluded = hidden.angle;
  s.out_all = all.outliers;
  s.out_visible = seen.outliers;
  s.out_occluded = hidden.outliers;
}

void
PairScorer::scoreSceneFlow (const Estimate& estimate, Score& s) const
{
  if (pair_.truth.scene_flow.empty())
    return;
  const cv::Mat& truth = pair_.truth.scene_flow;
  const auto all = evaluation::sceneFlowErrors (estimate.displacement, truth, all_);
  const auto seen =
      evaluation::sceneFlowErrors (estimate.displacement, truth, visible_);
  const auto hidden =
      evaluation::sceneFlowErrors (estimate.displacement, truth, occluded_);
  s.epe3d_all = all.epe;
  s.epe3d_visible = seen.epe;
  s.epe3d_occluded = hidden.epe;
  s.epe3d_median = seen.median;
  s.acc5_all = all.under_5cm;
  s.acc5_visible = seen.under_5cm;
  s.acc5_occluded = hidden.under_5cm;
  s.acc1_all = all.under_1cm;
  s.acc1_visible = seen.under_1cm;
  s.acc1_occluded = hidden.under_1cm;
}

void
PairScorer::scoreMotions (const Estimate& estimate, Score& s) const
{
  if (estimate.dominant)
    s.motion = estimate.dominant->parameters;
  if (pair_.camera_motion)
    s.true_motion = pair_.camera_motion->parameters;
  if (estimate.dominant && pair_.camera_motion) {
    const auto ego = evaluation::poseError (*estimate.dominant, *pair_.camera_motion);
    s.ego_rot = ego.rotation_deg;
    s.ego_trans = ego.translation_mm;
  }
  if (!estimate.scene_flow)
    return;
  const SceneFlow& flow = *estimate.scene_flow;
  s.segments = static_cast<double> (flow.segments.size());
  s.groups = flow.groups;
  s.converged = flow.report.converged ? 1.0 : 0.0;
  s.iterations = flow.report.iterations;
  if (pair_.truth.labels.empty())
    return;
  const cv::Mat groups = evaluation::motionGroups (flow);
  s.ari = evaluation::adjustedRandIndex (groups, pair_.truth.labels);
  s.purity = evaluation::groupPurity (groups, pair_.truth.labels);
  const auto segments =
      evaluation::segmentErrors (flow, pair_.truth.labels, pair_.truth.bodies);
  s.segment_rot = segments.rotation_deg;
  s.segment_trans = segments.translation_mm;
  s.segment_rot_median = segments.median_rotation_deg;
  s.segment_trans_median = segments.median_translation_mm;
  s.nees = segments.normalized_square;
  s.nees_median = segments.median_normalized_square;
  s.nees_groups = segments.groups_normalized_square;
}

/** Does what the method says of its errors sort them? */
void
PairScorer::scoreDeviation (const Estimate& estimate, Score& s) const
{
  if (!estimate.scene_flow || pair_.truth.flow.empty())
    return;
  const SceneFlow& flow = *estimate.scene_flow;
  const bool color = !pair_.reference.color.empty() && !pair_.current.color.empty();
  const cv::Mat residual = color ? io::brightnessResidual (pair_.reference.color,
                                                           pair_.current.color,
                                                           flow.flow)
                                 : io::depthResidual (flow, pair_.current.depth);
  const cv::Mat known = all_ & (flow.flow_deviation > 0.0F); // of the estimate
  const cv::Mat errors = evaluation::endPointErrors (flow.flow, pair_.truth.flow);
  s.ause = evaluation::sparsificationError (errors, flow.flow_deviation, known);
  s.ause_residual = evaluation::sparsificationError (errors, residual, known);
}

void
PairScorer::scoreResiduals (const Estimate& estimate,
                            const cv::Mat& seen,
                            Score& s) const
{
  if (!estimate.visible.empty())
    s.seen = cv::countNonZero (estimate.visible & all_) / s.points;
  const cv::Mat mask = seen.empty() ? all_ : cv::Mat (seen & all_);
  if (!pair_.reference.color.empty() && !pair_.current.color.empty()) {
    const auto all = evaluation::photometricResiduals (
        estimate.flow, pair_.reference.color, pair_.current.color, all_);
    s.photo_all_mean = all.mean;
    s.photo_all_median = all.median;
    const auto there = evaluation::photometricResiduals (
        estimate.flow, pair_.reference.color, pair_.current.color, mask);
    s.photo_mean = there.mean;
    s.photo_median = there.median;
  }
  if (estimate.lifted)
    return;
  const auto depth = evaluation::depthResiduals (points_,
                                                 estimate.displacement,
                                                 pair_.current.depth,
                                                 pair_.current.camera,
                                                 inverse_depth_noise_,
                                                 mask);
  s.depth_mean = depth.mean;
  s.depth_median = depth.median;
  s.depth_sigmas = depth.median_sigmas;
}

Score
PairScorer::score (const Estimate& estimate, const cv::Mat& seen) const
{
  Score s;
  s.points = cv::countNonZero (all_);
  scoreFlow (estimate, s);
  scoreSceneFlow (estimate, s);
  scoreMotions (estimate, s);
  scoreDeviation (estimate, s);
  scoreResiduals (estimate, seen, s);
  const StageSeconds& seconds = estimate.seconds;
  s.sec = seconds.total;
  s.sec_frame = seconds.frame;
  s.sec_segment = seconds.segment;
  s.sec_start = seconds.start;
  s.sec_solve = seconds.solve;
  s.sec_result = seconds.result;
  return s;
}

} // namespace pcl_msf::tool
