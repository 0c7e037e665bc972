// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_result.h"

#include "core/base/number_text.h"
#include "core/base/parallel_for.h"
#include "core/points/cloud_joints.h"
#include "core/points/limb_sections.h"
#include "core/points/loose_ends.h"
#include "core/points/rigid_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/** Information of a pose of points as given from that of scaled ones. */
Matrix6
informationAsGiven (const PointClouds& clouds,
                    const RigidPose& scaled,
                    const Matrix6& information)
{
  const auto& p = scaled.parameters;
  Eigen::Matrix<double, 6, 6> change = Eigen::Matrix<double, 6, 6>::Identity();
  change.bottomLeftCorner<3, 3>() = -skew (scaled.rotation() * clouds.center) *
                                    leftJacobian ({p[0], p[1], p[2]}) / clouds.size;
  change.bottomRightCorner<3, 3>() /= clouds.size;
  return change.transpose() * information * change;
}

void
addParts (const PointClouds& clouds, const RigidParts& parts, CloudFlow& flow)
{
  flow.parts.resize (parts.poses.size());
  const Surface& surface = clouds.source.surface;
  for (int i = 0; i < surface.size(); ++i)
    flow.parts[parts.part[i]].centroid += surface.points[i].cast<double>();
  for (std::size_t p = 0; p < flow.parts.size(); ++p) {
    CloudPart& part = flow.parts[p];
    part.target_from_source = clouds.asGiven (parts.poses[p]);
    part.information =
        informationAsGiven (clouds, parts.poses[p], parts.information[p]);
    part.centroid =
        clouds.size * part.centroid / std::max (1, parts.sizes[p]) + clouds.center;
  }
}

void
addJoints (const PointClouds& clouds,
           const RigidParts& parts,
           double least_share,
           CloudFlow& flow)
{
  std::vector<char> large;
  for (const int size : parts.sizes)
    large.push_back (size >= least_share * clouds.source.surface.size());
  std::vector<int> whole;
  for (const SurfaceSeam& seam :
       bodySeams (clouds.source.surface, parts.part, large, whole)) {
    CloudJoint joint = jointBetween (flow.parts[seam.first],
                                     flow.parts[seam.second],
                                     clouds.size * seam.center + clouds.center);
    joint.parent = seam.first;
    joint.child = seam.second;
    flow.joints.push_back (joint);
  }
}

/** What became of given segments. */
void
tellSegments (const PointClouds& clouds,
              const GivenSegments& given,
              const std::vector<Eigen::Vector3f>& source,
              const SurfaceSegments& segments,
              const RigidParts& parts,
              CloudFlow& flow)
{
  flow.segment = given.of;
  std::vector<int> part_of (segments.size(), -1); // of the working ones
  std::vector<int> number (segments.size(), -1);
  for (std::size_t i = 0; i < parts.part.size(); ++i) {
    part_of[segments.label[i]] = parts.part[i];
    number[segments.label[i]] = given.of[clouds.source.given[i]];
  }
  for (const int segment : workingSegments (clouds, given, source))
    flow.segment_part.push_back (part_of[segment]);
  for (const SegmentLink& link : segments.links)
    flow.touching.push_back ({number[link.first], number[link.second]});
}

/** How well the clouds lie on each other. \return the confidence per working point */
std::vector<float>
judge (const PointClouds& clouds,
       PointSolve& solve,
       const MovedPoints& moved,
       const PointResultTuning& tuning,
       int threads,
       CloudFlow& flow)
{
  const Surface& surface = clouds.source.surface;
  MatchRules rules;
  rules.normal_length = tuning.normal_length;
  const double spacing =
      std::max (surface.median_spacing, clouds.target.surface.median_spacing);
  const double limit = tuning.found * spacing;
  MatchTarget& target = solve.fineTarget();
  const Coverage coverage = target.covered (moved, rules, limit, threads);
  flow.explained_source = coverage.movedShare();
  flow.explained_target = coverage.samplesShare();
  MovedPoints samples;
  for (const int i : clouds.source.samples) {
    samples.points.push_back (moved.points[i]);
    samples.normals.push_back (moved.normals[i]);
  }
  const CloudEnds ends = looseEnds (clouds, samples, moved, limit, tuning, threads);
  flow.loose_target = ends.target.largest;
  flow.unexplained = ends.unexplained();
  flow.self_overlap = selfOverlap (surface, moved, tuning.overlap, threads);
  flow.gap = meanGap (solve.segments(), solve.poses());
  std::vector<float> confidence = target.distances (moved, rules, limit, threads);
  const std::vector<float> stretch = stretchOf (surface, moved.points, threads);
  for (std::size_t i = 0; i < confidence.size(); ++i)
    confidence[i] =
        (1.0f - confidence[i] / static_cast<float> (limit)) / (1.0f + stretch[i]);
  return confidence;
}

/** Every point goes as the nearest working point; that has its part's pose or, where
 * motions blend, its own shift. Those of given segments go with their part. */
void
carryAll (const PointClouds& clouds,
          const GivenSegments& given,
          const RigidParts& parts,
          const std::vector<Eigen::Vector3f>& source,
          const std::vector<float>& confidence,
          int threads,
          CloudFlow& flow)
{
  const Surface& surface = clouds.source.surface;
  const PointTree tree (surface.points);
  const PointTree target_tree (clouds.target.surface.points);
  const std::size_t n = source.size();
  flow.warped.assign (n, Eigen::Vector3f::Constant (kUnknown));
  flow.part.assign (n, -1);
  flow.target.assign (n, -1);
  flow.confidence.assign (n, 0.0f);
  parallelFor (threads, static_cast<int> (n), 256, [&] (int i) {
    const bool whole = !given.of.empty();
    if (!source[i].allFinite() || (whole && given.of[i] < 0))
      return;
    const Eigen::Vector3f p = clouds.scaled (source[i]);
    const int k = tree.nearest (p).index;
    const int part = whole ? flow.segment_part[given.of[i]] : parts.part[k];
    const RigidPose& pose = parts.poses[part];
    const Eigen::Vector3f offset =
        (pose.rotation() * (p - surface.points[k]).cast<double>()).cast<float>();
    const Eigen::Vector3f moved = whole ? (pose * p.cast<double>()).cast<float>().eval()
                                        : (parts.points[k] + offset).eval();
    flow.warped[i] = clouds.asGiven (moved);
    flow.part[i] = part;
    flow.confidence[i] = confidence[k];
    const int j = target_tree.nearest (moved).index;
    flow.target[i] = j < 0 ? -1 : clouds.target.given[j];
  });
  for (const int p : flow.part)
    if (p >= 0)
      ++flow.parts[p].points;
}

CloudFlow
makeCloudFlow (const PointFrame& frame,
               const RigidParts& parts,
               const GivenSegments& given,
               const std::vector<Eigen::Vector3f>& source,
               const PointTuning& tuning,
               int threads)
{
  CloudFlow flow;
  const PointClouds& clouds = frame.clouds;
  addParts (clouds, parts, flow);
  addJoints (clouds, parts, tuning.result.joint_share, flow);
  if (!given.labels.empty())
    tellSegments (clouds, given, source, frame.solve->segments(), parts, flow);
  const MovedPoints moved{parts.points, parts.normals, {}};
  const std::vector<float> confidence =
      judge (clouds, *frame.solve, moved, tuning.result, threads, flow);
  carryAll (clouds, given, parts, source, confidence, threads, flow);
  return flow;
}

} // namespace

std::vector<CloudFlow>
makeCloudFlows (const std::vector<PointFrame>& frames,
                const GivenSegments& given,
                const std::vector<Eigen::Vector3f>& source,
                bool merge,
                const PointTuning& tuning,
                int threads)
{
  const std::vector<RigidParts> parts = findParts (frames, merge, tuning, threads);
  std::vector<CloudFlow> flows;
  for (std::size_t f = 0; f < frames.size(); ++f)
    flows.push_back (
        makeCloudFlow (frames[f], parts[f], given, source, tuning, threads));
  return flows;
}

void
noteOutcome (const SolveProgress& progress,
             double scattered,
             const PointResultTuning& tuning,
             CloudFlow& flow)
{
  Report& report = flow.report;
  report.iterations = progress.iterations();
  report.history = progress.history();
  if (!report.history.empty()) {
    report.initial_cost.icp = report.history.front().cost;
    report.final_cost.icp = report.history.back().cost;
  }
  report.stop_reason = progress.stopped() ? progress.reason() : StopReason::Converged;
  if (progress.stopped())
    report.message = "ended before its end; the result is the best so far";
  else if (flow.explained_source < tuning.least_source) {
    report.stop_reason = StopReason::DifferentPlaces;
    report.message = "only " + fixedText (100.0 * flow.explained_source, 1) +
                     " % of the source is found on the target, too little to tell how "
                     "the rest moves: give a target that shows more of it";
  }
  else if (flow.unexplained > tuning.unexplained) {
    report.stop_reason = StopReason::DifferentPlaces;
    report.message =
        "parts of both clouds, " + fixedText (100.0 * flow.unexplained, 1) +
        " % or more, are not found on each other, nor cut off: give a start "
        "that is nearer, or clouds that show the same";
  }
  else if (flow.loose_target > tuning.loose) {
    report.stop_reason = StopReason::DifferentPlaces;
    report.message =
        fixedText (100.0 * flow.loose_target, 1) +
        " % of the target in one piece is bare though the source's surface goes on "
        "there: a limb lies elsewhere; give a start that is nearer";
  }
  else if (flow.self_overlap > tuning.overlap.most) {
    report.stop_reason = StopReason::DifferentPlaces;
    report.message = fixedText (100.0 * flow.self_overlap, 1) +
                     " % of the source has come to lie on another part of it: a limb "
                     "ended on another; give a start that is nearer";
  }
  else if (flow.gap > tuning.gap) {
    report.stop_reason = StopReason::DifferentPlaces;
    report.message = "the source is torn or twisted: its segments are " +
                     fixedText (flow.gap, 2) +
                     " of their radius apart, mean; give a start that is nearer";
  }
  else if (scattered > tuning.scattered) {
    report.stop_reason = StopReason::DifferentPlaces;
    report.message = fixedText (100.0 * scattered, 1) +
                     " % of both clouds lie off each other, by noise or motions that "
                     "the points do not tell: keep a camera's clouds organized, filter "
                     "to larger distances, or give a start that is nearer";
  }
  report.converged = report.stop_reason == StopReason::Converged;
}

} // namespace pcl_msf
