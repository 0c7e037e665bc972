// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_clouds.h"
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/neighbor_registration.h>
#include <pcl_msf/impl/registration_steps.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace pcl_msf {
namespace detail {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

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

/** None of none. */
template <typename T>
std::vector<T>
choose (const std::vector<T>& all, const pcl::Indices& indices)
{
  std::vector<T> chosen;
  if (all.empty())
    return chosen;
  chosen.reserve (indices.size());
  for (const auto index : indices)
    chosen.push_back (all[index]);
  return chosen;
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
  flow.visibility =
      cv::Mat (source.size(), CV_8UC1, cv::Scalar (pixelValue (Visibility::NoDepth)));
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
  const int label = (found.segment.empty() ? found.part : found.segment)[from];
  flow.labels.ptr<int> (0)[to] = label;
  flow.visibility.ptr<unsigned char> (0)[to] =
      pixelValue (seen ? Visibility::Visible : Visibility::Unknown);
  if (label >= 0)
    flow.segments[label].visible_points += seen ? 1 : 0;
}

/** Could a camera in the origin have seen all of the points? */
bool
isCameraView (const cv::Mat& points)
{
  for (std::size_t i = 0; i < points.total(); ++i) {
    const Eigen::Vector3f p = pointAt (points, i);
    if (p.allFinite() && !isInCameraView (p))
      return false;
  }
  return true;
}

/** Adds what helps when a filter has made a list of a camera's cloud. */
void
hintAtLostGrid (const cv::Mat& source, const cv::Mat& target, Report& report)
{
  const auto listed = [] (const cv::Mat& m) { return m.rows == 1 || m.cols == 1; };
  const bool lost = listed (source) || listed (target);
  if (report.stop_reason == StopReason::DifferentPlaces && lost &&
      isCameraView (source) && isCameraView (target))
    report.message += "; if a camera took them, keep the clouds organized, which tells "
                      "more than nearest neighbours: setKeepOrganized (true) of the "
                      "filter, no removeNaNFromPointCloud or VoxelGrid";
}

/** Pairs and weights of all source points as those of the chosen ones.
 * \throws InvalidInput for indices that there are none of */
CloudConstraints
chooseConstraints (const NeighborTask& task)
{
  CloudConstraints chosen = task.constraints;
  const std::size_t size = task.source.total();
  if (!chosen.point_weights.empty() && chosen.point_weights.size() != size)
    throw InvalidInput (
        "there are " + std::to_string (chosen.point_weights.size()) + " weights for " +
        std::to_string (size) +
        " points: give setCloudConstraints one per point of the source");
  if (!chosen.point_weights.empty())
    chosen.point_weights = choose (task.constraints.point_weights, task.points);
  std::vector<int> place (size, -1);
  for (std::size_t i = 0; i < task.points.size(); ++i)
    place[task.points[i]] = static_cast<int> (i);
  chosen.pairs.clear();
  for (KnownPair pair : task.constraints.pairs) {
    if (static_cast<std::size_t> (pair.source) >= size)
      throw InvalidInput ("a known pair has index " + std::to_string (pair.source) +
                          ", the source only " + std::to_string (size) +
                          " points: give indices of the two clouds");
    pair.source = place[pair.source];
    if (pair.source >= 0)
      chosen.pairs.push_back (pair);
  }
  return chosen;
}

/** The scene flow's segments are the parts. */
void
addParts (const CloudFlow& found, SceneFlow& flow)
{
  for (std::size_t p = 0; p < found.parts.size(); ++p) {
    flow.segments.push_back (motionOf (found.parts[p], static_cast<int> (p)));
    flow.group_motions.push_back (
        {found.parts[p].target_from_source, found.parts[p].information, 1});
  }
  for (const CloudJoint& joint : found.joints)
    flow.pairs.push_back ({joint.parent, joint.child, 0.0, 0.0});
}

/** The scene flow's segments are the given ones, its groups the parts. */
void
addGivenSegments (const CloudFlow& found, SceneFlow& flow)
{
  for (const CloudPart& part : found.parts)
    flow.group_motions.push_back ({part.target_from_source, part.information, 0});
  for (const int part : found.segment_part) {
    flow.segments.push_back (motionOf (found.parts[part], part));
    flow.segments.back().points = 0;
    flow.segments.back().centroid.setZero();
    ++flow.group_motions[part].segments;
  }
  for (const auto& [first, second] : found.touching) {
    const bool joined = found.segment_part[first] == found.segment_part[second];
    flow.pairs.push_back ({first, second, joined ? 1.0 : 0.0, 0.0});
  }
}

/** Points and centroids of given segments. */
void
countPoints (const CloudFlow& found, const pcl::Indices& points, SceneFlow& flow)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (found.part[i] >= 0) {
      SegmentMotion& segment = flow.segments[found.segment[i]];
      ++segment.points;
      segment.centroid += pointAt (flow.points, points[i]).cast<double>();
    }
  for (SegmentMotion& segment : flow.segments)
    segment.centroid /= std::max (1, segment.points);
}

/** The clouds in the order of time. */
std::vector<CloudFrame>
framesOf (const NeighborTask& task)
{
  std::vector<CloudFrame> frames;
  for (std::size_t t = 0; t < task.targets.size(); ++t)
    frames.push_back ({pointsOf (task.targets[t]), task.target_brightness[t]});
  frames.insert (frames.begin() + task.reference,
                 {choose (pointsOf (task.source), task.points),
                  choose (task.brightness, task.points),
                  choose (task.normals, task.points)});
  return frames;
}

void
fillFlow (const CloudFlow& found, const NeighborTask& task, SceneFlow& flow)
{
  prepareImages (task.source, flow);
  if (found.segment.empty())
    addParts (found, flow);
  else {
    addGivenSegments (found, flow);
    countPoints (found, task.points, flow);
  }
  for (std::size_t i = 0; i < task.points.size(); ++i)
    fillPoint (found, i, task.points[i], flow);
  flow.groups = static_cast<int> (found.parts.size());
  flow.dominant_group = 0;
  flow.dominant_motion = found.parts.front().target_from_source;
}

PairMotion
pairMotion (const SceneFlow& flow, int from, int to)
{
  PairMotion motion{from, to, {}};
  for (const SegmentMotion& segment : flow.segments)
    motion.segments.push_back (segment.current_from_reference);
  return motion;
}

/** The reference's report is the window's: that of the first frame that was not found,
 * with what has been added to it. */
void
tellWindow (MultiframeSceneFlow& window)
{
  for (std::size_t f = 0; f < window.frames.size(); ++f)
    if (static_cast<int> (f) != window.reference &&
        !window.frames[f].report.converged) {
      window.frames[window.reference].report = window.frames[f].report;
      return;
    }
}

} // namespace

std::vector<int>
pointLabels (const pcl::PointCloud<pcl::Label>& labels)
{
  std::vector<int> result;
  for (const pcl::Label& l : labels.points) {
    constexpr std::uint32_t largest = std::numeric_limits<int>::max();
    result.push_back (l.label <= largest ? static_cast<int> (l.label) : -1);
  }
  return result;
}

std::vector<int>
clusterLabels (const std::vector<pcl::PointIndices>& clusters, std::size_t size)
{
  std::vector<int> labels (size, -1);
  for (std::size_t k = 0; k < clusters.size(); ++k)
    for (const auto index : clusters[k].indices) {
      if (index < 0 || static_cast<std::size_t> (index) >= size)
        throw InvalidInput ("cluster " + std::to_string (k) + " has index " +
                            std::to_string (index) + ", the cloud only " +
                            std::to_string (size) +
                            " points: give setSegmentation the source's own clusters");
      if (labels[index] < 0)
        labels[index] = static_cast<int> (k);
    }
  return labels;
}

std::vector<Eigen::Vector3f>
pointNormals (const pcl::PointCloud<pcl::Normal>& normals)
{
  std::vector<Eigen::Vector3f> result;
  result.reserve (normals.size());
  for (const pcl::Normal& n : normals)
    result.emplace_back (n.normal_x, n.normal_y, n.normal_z);
  return result;
}

const std::vector<CloudJoint>&
noJoints ()
{
  static const std::vector<CloudJoint> none;
  return none;
}

NeighborRegistration
registerByNeighbors (const NeighborTask& task)
{
  const std::vector<CloudFlow> found =
      CloudFlowEstimator (task.solver, chooseConstraints (task), task.multiframe)
          .estimateWindow (framesOf (task),
                           task.reference,
                           task.start,
                           choose (task.labels, task.points),
                           task.brightness_weight);
  NeighborRegistration result;
  result.target.assign (task.source.total(), -1);
  result.flow.reference = task.reference;
  result.flow.frames.resize (found.size());
  const int frames = static_cast<int> (found.size());
  const int last = lastTarget (frames, task.reference);
  for (int f = 0; f < frames; ++f) {
    SceneFlow& flow = result.flow.frames[f];
    flow.report = found[f].report;
    result.joints.push_back (found[f].joints);
    if (f == task.reference)
      continue;
    fillFlow (found[f], task, flow);
    hintAtLostGrid (
        task.source, task.targets[f < task.reference ? f : f - 1], flow.report);
    result.flow.motions.push_back (pairMotion (flow, task.reference, f));
    if (f == last)
      for (std::size_t i = 0; i < task.points.size(); ++i)
        result.target[task.points[i]] = found[f].target[i];
  }
  tellWindow (result.flow);
  return result;
}

} // namespace detail
} // namespace pcl_msf
