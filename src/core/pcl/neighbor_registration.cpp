// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/impl/neighbor_registration.h>

#include <cstddef>
#include <limits>

namespace pcl_msf {
namespace detail {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kWidestView = 2.0f; // x or y by z: 127 degrees from side to side

Eigen::Vector3f
pointAt (const cv::Mat& image, std::size_t index)
{
  const cv::Vec3f& p = image.ptr<cv::Vec3f> (0)[index]; // continuous
  return {p[0], p[1], p[2]};
}

std::vector<Eigen::Vector3f>
pointsOf (const cv::Mat& image)
{
  std::vector<Eigen::Vector3f> points (image.total());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = pointAt (image, i);
  return points;
}

SegmentMotion
motionOf (const CloudPart& part, int group)
{
  SegmentMotion motion;
  motion.current_from_reference = part.target_from_source;
  motion.information = part.information;
  motion.rank = 6;
  motion.status = MotionStatus::Determined;
  motion.points = part.points;
  motion.group = group;
  motion.centroid = part.centroid;
  return motion;
}

void
prepareImages (const cv::Mat& source, SceneFlow& flow)
{
  flow.points = source.clone();
  flow.labels = cv::Mat (source.size(), CV_32SC1, cv::Scalar (-1));
  flow.displacement = cv::Mat (source.size(), CV_32FC3, cv::Scalar::all (kNone));
  flow.flow = cv::Mat (source.size(), CV_32FC2, cv::Scalar::all (kNone));
  flow.visibility = cv::Mat (source.size(), CV_8UC1, cv::Scalar (Visibility::NoDepth));
  flow.flow_deviation = cv::Mat (source.size(), CV_32FC1, cv::Scalar::all (kNone));
  flow.displacement_deviation = flow.flow_deviation.clone();
}

void
fillPoint (const CloudFlow& found, std::size_t from, std::size_t to, SceneFlow& flow)
{
  const Eigen::Vector3f d = found.warped[from] - pointAt (flow.points, to);
  if (!d.allFinite())
    return;
  const bool seen = found.confidence[from] > 0.0f;
  flow.displacement.ptr<cv::Vec3f> (0)[to] = {d.x(), d.y(), d.z()};
  flow.labels.ptr<int> (0)[to] = found.part[from];
  flow.visibility.ptr<unsigned char> (0)[to] =
      seen ? Visibility::Visible : Visibility::Unknown;
  if (found.part[from] >= 0)
    flow.segments[found.part[from]].visible_points += seen ? 1 : 0;
}

/** Could a camera in the origin have seen all of the points? */
bool
isCameraView (const cv::Mat& points)
{
  for (std::size_t i = 0; i < points.total(); ++i) {
    const Eigen::Vector3f p = pointAt (points, i);
    if (p.allFinite() && !(p.head<2>().cwiseAbs().maxCoeff() < kWidestView * p.z()))
      return false;
  }
  return true;
}

/** Adds what helps when a filter has made a list of a camera's cloud. */
void
hintAtLostGrid (const cv::Mat& source, const cv::Mat& target, Report& report)
{
  const bool lost = source.rows == 1 || target.rows == 1;
  if (report.stop_reason == StopReason::DifferentPlaces && lost &&
      isCameraView (source) && isCameraView (target))
    report.message += "; if a camera took them, keep the clouds organized, which tells "
                      "more than nearest neighbours: setKeepOrganized (true) of the "
                      "filter, no removeNaNFromPointCloud or VoxelGrid";
}

} // namespace

NeighborRegistration
registerByNeighbors (const cv::Mat& source,
                     const cv::Mat& target,
                     const pcl::Indices& points,
                     const SolverParameters& solver,
                     const RigidPose& start)
{
  std::vector<Eigen::Vector3f> chosen;
  chosen.reserve (points.size());
  for (const auto index : points)
    chosen.push_back (pointAt (source, index));
  CloudFlow found =
      CloudFlowEstimator (solver).estimate (chosen, pointsOf (target), start);
  NeighborRegistration result;
  result.joints = std::move (found.joints);
  result.target.assign (source.total(), -1);
  result.flow.frames.resize (2);
  SceneFlow& flow = result.flow.frames[1];
  prepareImages (source, flow);
  PairMotion motion{0, 1, {}};
  for (std::size_t p = 0; p < found.parts.size(); ++p) {
    flow.segments.push_back (motionOf (found.parts[p], static_cast<int> (p)));
    flow.group_motions.push_back (
        {found.parts[p].target_from_source, found.parts[p].information, 1});
    motion.segments.push_back (found.parts[p].target_from_source);
  }
  result.flow.motions.push_back (std::move (motion));
  for (const CloudJoint& joint : result.joints)
    flow.pairs.push_back ({joint.parent, joint.child, 0.0, 0.0});
  for (std::size_t i = 0; i < points.size(); ++i) {
    fillPoint (found, i, points[i], flow);
    result.target[points[i]] = found.target[i];
  }
  flow.groups = static_cast<int> (found.parts.size());
  flow.dominant_group = 0;
  flow.dominant_motion = found.parts.front().target_from_source;
  hintAtLostGrid (source, target, found.report);
  flow.report = found.report;
  result.flow.frames[0].report = found.report;
  return result;
}

} // namespace detail
} // namespace pcl_msf
