// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include "core/base/flatten.h"
#include "evaluation/check_images.h"
#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/evaluation/motion_errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace pcl_msf::evaluation {

namespace {

/** The label that most of each segment's points bear; -1 = none of them has one. */
std::vector<int>
bodyOfSegments (const cv::Mat& segments, int count, const cv::Mat& labels)
{
  std::vector<std::map<int, int>> votes (count);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      const int k = segments.at<int> (y, x);
      const int label = labels.at<int> (y, x);
      if (k >= 0 && label >= 0)
        ++votes[k][label];
    }
  std::vector<int> bodies (count, -1);
  for (int k = 0; k < count; ++k) {
    int most = 0;
    for (const auto& [label, n] : votes[k])
      if (n > most) {
        most = n;
        bodies[k] = label;
      }
  }
  return bodies;
}

/** Squared error in standard deviations; motions are small, so the parameters'
 * difference is the error. */
double
normalizedSquare (const RigidPose& pose,
                  const Matrix6& information,
                  const RigidPose& truth)
{
  Vector6 error;
  for (int i = 0; i < 6; ++i)
    error[i] = pose.parameters[i] - truth.parameters[i];
  return error.dot (information * error);
}

/** Mean over groups with determined segments, each held against the body that most of
 * its segments' points are of; NaN for none. */
double
groupsNormalizedSquare (const SceneFlow& estimate,
                        const std::vector<int>& body_of,
                        const std::vector<std::optional<RigidPose>>& bodies)
{
  std::vector<std::map<int, long>> votes (estimate.group_motions.size());
  for (std::size_t k = 0; k < body_of.size(); ++k) {
    const SegmentMotion& segment = estimate.segments[k];
    const bool voting = segment.group >= 0 &&
                        segment.group < static_cast<int> (votes.size()) &&
                        segment.status == MotionStatus::Determined;
    if (voting)
      votes[segment.group][body_of[k]] += segment.points;
  }
  std::vector<double> squares;
  for (std::size_t g = 0; g < votes.size(); ++g) {
    const auto most = std::max_element (
        votes[g].begin(), votes[g].end(), [] (const auto& a, const auto& b) {
          return a.second < b.second;
        });
    if (most == votes[g].end() || most->first < 0 ||
        most->first >= static_cast<int> (bodies.size()) || !bodies[most->first])
      continue;
    const GroupMotion& group = estimate.group_motions[g];
    squares.push_back (normalizedSquare (
        group.current_from_reference, group.information, *bodies[most->first]));
  }
  return mean (squares);
}

struct PointPairs {
  std::vector<Eigen::Vector3d> from, to;
};

/** Flat, so that no copy of Eigen's umeyama is left that a program's own, with another
 * alignment, could replace. */
PCL_MSF_FLATTEN RigidPose
fit (const PointPairs& pairs)
{
  const auto n = static_cast<Eigen::Index> (pairs.from.size());
  if (n == 0)
    return {};
  Eigen::Matrix3Xd from (3, n), to (3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    from.col (i) = pairs.from[i];
    to.col (i) = pairs.to[i];
  }
  if (n < 3)
    return RigidPose::fromMatrix (Eigen::Matrix3d (Eigen::Matrix3d::Identity()),
                                  Eigen::Vector3d ((to - from).rowwise().mean()));
  const Eigen::Matrix4d m = Eigen::umeyama (from, to, false);
  return RigidPose::fromMatrix (Eigen::Matrix3d (m.topLeftCorner<3, 3>()),
                                Eigen::Vector3d (m.topRightCorner<3, 1>()));
}

} // namespace

SegmentErrors::SegmentErrors()
: rotation_deg (std::numeric_limits<double>::quiet_NaN())
, translation_mm (rotation_deg)
, median_rotation_deg (rotation_deg)
, median_translation_mm (rotation_deg)
, normalized_square (rotation_deg)
, median_normalized_square (rotation_deg)
, groups_normalized_square (rotation_deg)
{}

PoseError
poseError (const RigidPose& estimate, const RigidPose& truth, const Eigen::Vector3d& at)
{
  const Eigen::Matrix3d difference = estimate.rotation() * truth.rotation().transpose();
  return {vectorFromRotation (difference).norm() * 180.0 / M_PI,
          1000.0 * (estimate * at - truth * at).norm()};
}

SegmentErrors
segmentErrors (const SceneFlow& estimate,
               const cv::Mat& labels,
               const std::vector<std::optional<RigidPose>>& bodies)
{
  requireImage ("labels", labels, CV_32SC1, estimate.labels.size());
  const auto count = static_cast<int> (estimate.segments.size());
  const std::vector<int> body_of = bodyOfSegments (estimate.labels, count, labels);
  std::vector<double> rotations, translations, squares;
  double points = 0.0, rotation = 0.0, translation = 0.0;
  for (int k = 0; k < count; ++k) {
    const int body = body_of[k];
    if (body < 0 || body >= static_cast<int> (bodies.size()) || !bodies[body])
      continue;
    const SegmentMotion& segment = estimate.segments[k];
    const bool known = segment.status != MotionStatus::Undetermined;
    const PoseError error =
        poseError (known ? segment.current_from_reference : RigidPose{},
                   *bodies[body],
                   segment.centroid);
    rotations.push_back (error.rotation_deg);
    translations.push_back (error.translation_mm);
    rotation += segment.points * error.rotation_deg;
    translation += segment.points * error.translation_mm;
    points += segment.points;
    if (segment.status == MotionStatus::Determined)
      squares.push_back (normalizedSquare (
          segment.current_from_reference, segment.information, *bodies[body]));
  }
  SegmentErrors result;
  if (rotations.empty())
    return result;
  result.segments = static_cast<int> (rotations.size());
  result.rotation_deg = rotation / points;
  result.translation_mm = translation / points;
  result.median_rotation_deg = median (std::move (rotations));
  result.median_translation_mm = median (std::move (translations));
  result.groups_normalized_square = groupsNormalizedSquare (estimate, body_of, bodies);
  if (squares.empty())
    return result;
  result.normalized_square =
      std::accumulate (squares.begin(), squares.end(), 0.0) / squares.size();
  result.median_normalized_square = median (std::move (squares));
  return result;
}

std::vector<RigidPose>
fitSegments (const cv::Mat& labels,
             const cv::Mat& points,
             const cv::Mat& scene_flow,
             int segments)
{
  requireImage ("labels", labels, CV_32SC1, labels.size());
  requireImage ("points", points, CV_32FC3, labels.size());
  requireImage ("scene flow", scene_flow, CV_32FC3, labels.size());
  std::vector<PointPairs> pairs (segments);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      const int k = labels.at<int> (y, x);
      const cv::Vec3f p = points.at<cv::Vec3f> (y, x);
      const cv::Vec3f q = p + scene_flow.at<cv::Vec3f> (y, x);
      if (k < 0 || k >= segments || !std::isfinite (q[0] + q[1] + q[2]))
        continue;
      pairs[k].from.emplace_back (p[0], p[1], p[2]);
      pairs[k].to.emplace_back (q[0], q[1], q[2]);
    }
  std::vector<RigidPose> poses (segments);
  std::transform (pairs.begin(), pairs.end(), poses.begin(), fit);
  return poses;
}

} // namespace pcl_msf::evaluation
