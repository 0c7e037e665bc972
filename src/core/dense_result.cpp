// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/dense_result.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_msf {

namespace {

constexpr double kConnected = 0.5;   // lifting weight of a surviving connection
constexpr double kSeenEnough = 0.15; // share of visible points that decides
constexpr double kRankShare = 1e-5;  // of the largest eigenvalue

/** Rank of an information matrix about the segment's own centroid, with rotations
 * measured at its radius, so that all six directions are metres. */
int
numericalRank (const Matrix6& information,
               const RigidPose& pose,
               const Eigen::Vector3d& c,
               double radius)
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
    rank += eigen.eigenvalues()[i] > kRankShare * eigen.eigenvalues()[5] &&
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

Visibility
visibilityOf (std::uint8_t active)
{
  if (active & kernel::kOutside)
    return OutOfView;
  if (active & kernel::kOccluded)
    return Occluded;
  return active & kernel::kIcp ? Visible : Unknown;
}

void
fillOwnMotion (const DataTerm& data,
               const MotionState& state,
               double residual_scale,
               int k,
               SegmentMotion& motion)
{
  const SegmentPixels& p = data.pixels();
  motion.current_from_reference = state.poseOf (k);
  motion.body = state.body_of[k];
  motion.centroid = p.centroid[k];
  motion.points = p.size (k);
  motion.visible_points = 0;
  for (int i = p.begin[k]; i < p.begin[k + 1]; ++i)
    motion.visible_points += (data.active()[i] & kernel::kIcp) ? 1 : 0;
  motion.information = residual_scale * data.of (k).information;
  motion.rank = numericalRank (motion.information,
                               motion.current_from_reference,
                               p.centroid[k],
                               radiusOf (p, k));
  const bool seen = motion.visible_points > kSeenEnough * motion.points;
  motion.status =
      seen && motion.rank == 6 ? MotionStatus::Determined : MotionStatus::Undetermined;
}

/** Undetermined segments are supported by determined ones of their body or beyond a
 * strong link, over any number of links. */
void
spreadSupport (const std::vector<SegmentPair>& pairs,
               std::vector<SegmentMotion>& segments)
{
  bool changed = true;
  while (changed) {
    changed = false;
    for (const SegmentPair& pair : pairs) {
      SegmentMotion& a = segments[pair.first];
      SegmentMotion& b = segments[pair.second];
      if (pair.weight < kConnected && a.body != b.body)
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

/** Motion groups: bodies joined by surviving weights between nearly equal motions. */
void
numberBodies (std::vector<SegmentMotion>& segments, SceneFlow& result)
{
  std::vector<int> points;
  for (const SegmentMotion& s : segments) {
    if (s.body >= static_cast<int> (points.size()))
      points.resize (s.body + 1, 0);
    points[s.body] += s.points;
  }
  std::vector<int> order (points.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (
      order.begin(), order.end(), [&] (int a, int b) { return points[a] > points[b]; });
  std::vector<int> rank (points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[order[i]] = static_cast<int> (i);
  for (SegmentMotion& s : segments)
    s.body = rank[s.body];
  result.bodies = static_cast<int> (points.size());
  result.dominant_body = points.empty() ? -1 : 0;
}

} // namespace

void
fillSegments (const DataTerm& data,
              const std::vector<SegmentLink>& links,
              const MotionState& state,
              double residual_scale,
              SceneFlow& result)
{
  const int segments = data.pixels().segments();
  result.segments.resize (segments);
  for (int k = 0; k < segments; ++k)
    fillOwnMotion (data, state, residual_scale, k, result.segments[k]);
  result.pairs.clear();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool one_body =
        state.body_of[links[i].first] == state.body_of[links[i].second];
    result.pairs.push_back ({links[i].first,
                             links[i].second,
                             one_body ? 1.0 : std::abs (state.weights[i])});
  }
  spreadSupport (result.pairs, result.segments);
  numberBodies (result.segments, result);
  for (const SegmentMotion& s : result.segments)
    if (s.body == result.dominant_body) {
      result.dominant_motion = s.current_from_reference;
      break;
    }
}

void
fillPoints (const DataTerm& data,
            const PinholeCamera& camera,
            int threads,
            SceneFlow& result)
{
  const SegmentPixels& p = data.pixels();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Size size = result.labels.size();
  result.points = cv::Mat (size, CV_32FC3, cv::Scalar::all (nan));
  result.displacement = cv::Mat (size, CV_32FC3, cv::Scalar::all (nan));
  result.flow = cv::Mat (size, CV_32FC2, cv::Scalar::all (nan));
  result.visibility = cv::Mat (size, CV_8UC1, cv::Scalar (NoDepth));
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
  for (int k = 0; k < p.segments(); ++k) {
    const SegmentMotion& motion = result.segments[k];
    const Eigen::Matrix3d r = motion.current_from_reference.rotation();
    const Eigen::Vector3d t = motion.current_from_reference.translation();
    for (int i = p.begin[k]; i < p.begin[k + 1]; ++i) {
      const int x = p.pixel[i] % size.width;
      const int y = p.pixel[i] / size.width;
      const Eigen::Vector3d point (p.x[i], p.y[i], p.z[i]);
      result.points.at<cv::Vec3f> (y, x) = {p.x[i], p.y[i], p.z[i]};
      result.visibility.at<unsigned char> (y, x) = visibilityOf (data.active()[i]);
      if (motion.status == MotionStatus::Undetermined) {
        result.visibility.at<unsigned char> (y, x) = Unknown;
        continue;
      }
      const Eigen::Vector3d q = r * point + t;
      const Eigen::Vector3f d = (q - point).cast<float>();
      result.displacement.at<cv::Vec3f> (y, x) = {d.x(), d.y(), d.z()};
      if (q.z() <= 1e-3)
        continue;
      const Eigen::Vector2d uv = camera.project (q);
      result.flow.at<cv::Vec2f> (y, x) = {static_cast<float> (uv.x() - x),
                                          static_cast<float> (uv.y() - y)};
    }
  }
}

} // namespace pcl_msf
