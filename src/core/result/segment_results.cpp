// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/segment_results.h"

#include <Eigen/Eigenvalues>

#include "core/base/flatten.h"
#include "core/result/link_evidence.h"
#include "core/result/motion_groups.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** Rank of an information matrix about the segment's own centroid, with rotations
 * measured at its radius, so that all six directions are metres. Flat as the factor of
 * a CompressedBlock. */
PCL_MSF_FLATTEN int
numericalRank (const Matrix6& information,
               const RigidPose& pose,
               const Eigen::Vector3d& c,
               double radius,
               double rank_share)
{
  const Eigen::Matrix3d j =
      leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]});
  // Pose parameters of a motion (omega, tau) about the warped centroid.
  Matrix6 basis = Matrix6::Identity();
  const Eigen::Matrix3d inverse = j.inverse();
  basis.topLeftCorner<3, 3>() = inverse / std::max (radius, 1e-6);
  basis.bottomLeftCorner<3, 3>() = skew (pose.rotation() * c) / std::max (radius, 1e-6);
  const Eigen::Matrix<double, 6, 6> local = basis.transpose() * information * basis;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen (
      local, Eigen::EigenvaluesOnly);
  int rank = 0;
  for (int i = 0; i < 6; ++i)
    rank += eigen.eigenvalues()[i] > rank_share * eigen.eigenvalues()[5] &&
            eigen.eigenvalues()[i] > 0.0;
  return rank;
}

double
radiusOf (const SegmentPixels& p, int k)
{
  double sum = 0.0;
  for (int i = p.begin[k]; i < p.begin[k + 1]; ++i)
    sum += (Eigen::Vector3d (p.x[i], p.y[i], p.z[i]) - p.centroid[k]).squaredNorm();
  return std::sqrt (sum / std::max (1, p.size (k)));
}

void
fillOwnMotion (const DataTerm& data,
               const MotionState& state,
               double residual_scale,
               const StatusTuning& tuning,
               int k,
               SegmentMotion& motion)
{
  const SegmentPixels& p = data.pixels();
  motion.current_from_reference = state.poseOf (k);
  motion.centroid = p.centroid[k];
  motion.points = p.pixels (k);
  motion.visible_points = 0;
  for (int i = p.begin[k]; i < p.begin[k + 1]; ++i)
    motion.visible_points +=
        (data.active()[i] & kernel::kIcp) ? p.pixels_per_point[k] : 0;
  motion.rank = numericalRank (residual_scale * data.of (k).information,
                               motion.current_from_reference,
                               p.centroid[k],
                               radiusOf (p, k),
                               tuning.rank_share);
  const bool seen = motion.visible_points > tuning.seen_enough * motion.points;
  motion.status =
      seen && motion.rank == 6 ? MotionStatus::Determined : MotionStatus::Undetermined;
}

/** Segments whose own points leave a freedom are supported by their body when all its
 * points together leave none. */
void
supportBodies (const DataTerm& data,
               const MotionState& state,
               double residual_scale,
               double rank_share,
               std::vector<SegmentMotion>& segments)
{
  const SegmentPixels& p = data.pixels();
  std::vector<Matrix6> information (state.poses.size(), Matrix6::Zero());
  std::vector<Eigen::Vector3d> center (state.poses.size(), Eigen::Vector3d::Zero());
  std::vector<double> points (state.poses.size(), 0.0);
  std::vector<double> spread (state.poses.size(), 0.0);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const int b = state.body_of[k];
    information[b] += residual_scale * data.of (static_cast<int> (k)).information;
    center[b] += segments[k].points * segments[k].centroid;
    points[b] += segments[k].points;
  }
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const int b = state.body_of[k];
    const double radius = radiusOf (p, static_cast<int> (k));
    const Eigen::Vector3d mean = center[b] / std::max (1.0, points[b]);
    spread[b] += segments[k].points *
                 (radius * radius + (segments[k].centroid - mean).squaredNorm());
  }
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const int b = state.body_of[k];
    const double n = std::max (1.0, points[b]);
    const bool whole = numericalRank (information[b],
                                      state.poses[b],
                                      center[b] / n,
                                      std::sqrt (spread[b] / n),
                                      rank_share) == 6;
    if (segments[k].status == MotionStatus::Undetermined && whole)
      segments[k].status = MotionStatus::Supported;
  }
}

/** Undetermined segments are supported by determined ones of their body or beyond a
 * strong link, over any number of links. */
void
spreadSupport (const std::vector<SegmentPair>& pairs,
               const std::vector<int>& body_of,
               double connected,
               std::vector<SegmentMotion>& segments)
{
  bool changed = true;
  while (changed) {
    changed = false;
    for (const SegmentPair& pair : pairs) {
      SegmentMotion& a = segments[pair.first];
      SegmentMotion& b = segments[pair.second];
      if (pair.weight < connected && body_of[pair.first] != body_of[pair.second])
        continue;
      const bool a_known = a.status != MotionStatus::Undetermined;
      const bool b_known = b.status != MotionStatus::Undetermined;
      if (a_known == b_known)
        continue;
      (a_known ? b : a).status = MotionStatus::Supported;
      changed = true;
    }
  }
}

double
mixingOf (LinkEvidence evidence, double weight)
{
  if (evidence == LinkEvidence::None)
    return weight * weight;
  return evidence == LinkEvidence::Soft ? 1.0 : 0.0;
}

} // namespace

void
fillSegments (const DataTerm& data,
              const std::vector<SegmentLink>& links,
              const MotionState& state,
              double residual_scale,
              const ResultTuning& tuning,
              int threads,
              SceneFlow& result)
{
  const int segments = data.pixels().segments();
  result.segments.resize (segments);
  for (int k = 0; k < segments; ++k)
    fillOwnMotion (data, state, residual_scale, tuning.status, k, result.segments[k]);
  result.pairs.clear();
  const auto evidence = classifyLinks (data, links, state, tuning.soft, threads);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool one_body =
        state.body_of[links[i].first] == state.body_of[links[i].second];
    const double weight = one_body ? 1.0 : std::abs (state.weights[i]);
    result.pairs.push_back (
        {links[i].first, links[i].second, weight, mixingOf (evidence[i], weight)});
  }
  supportBodies (
      data, state, residual_scale, tuning.status.rank_share, result.segments);
  spreadSupport (result.pairs, state.body_of, tuning.status.connected, result.segments);
  numberGroups (state, tuning.groups, result);
}

} // namespace pcl_msf
