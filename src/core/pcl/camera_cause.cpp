// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/pcl/camera_cause.h"

#include <Eigen/Geometry>

#include "core/base/flatten.h"
#include "core/base/number_text.h"
#include "core/pcl/cloud_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

constexpr double kExplained = 1.0;   // pixels, median error of a pose that is the cause
constexpr double kMuchBetter = 0.3;  // of the simpler pose's error
constexpr double kAxesDegrees = 3.0; // an installation's tilt from exchanged axes
constexpr double kTinyDegrees = 0.05; // and
constexpr double kTinyPixels = 0.05;  // what float coordinates leave of no motion
constexpr double kSameScale = 0.01;   // relative difference of focal lengths
constexpr double kManyAlike = 0.1;    // share of the points
constexpr double kFlat = 0.01;        // of the extent

const char* const kTransformBack = "; transform the cloud back to the camera's optical "
                                   "frame first (x right, y down, z forward)";

/** The nearest matrix of zeros and signs: which axis is which. */
Eigen::Matrix3d
nearestAxes (const Eigen::Matrix3d& rotation)
{
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  for (int row = 0; row < 3; ++row) {
    Eigen::Index axis = 0;
    rotation.row (row).cwiseAbs().maxCoeff (&axis);
    axes (row, axis) = rotation (row, axis) > 0.0 ? 1.0 : -1.0;
  }
  return axes;
}

/** Rotation vector; none of Eigen's functions for aligned types is left shared. */
PCL_MSF_FLATTEN Eigen::Vector3d
turnOf (const Eigen::Matrix3d& rotation)
{
  const Eigen::AngleAxisd turn (rotation);
  return turn.angle() * turn.axis();
}

/** Angle of the rotation between two frames of one handedness. */
double
degreesBetween (const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
  return turnOf (a * b.transpose()).norm() * 180.0 / M_PI;
}

/** "x is forward, y is left, z is up" */
std::string
axesText (const Eigen::Matrix3d& axes)
{
  static const std::array<std::array<const char*, 2>, 3> kWords{
      {{"left", "right"}, {"up", "down"}, {"back", "forward"}}};
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row)
      if (axes (row, axis) != 0.0) {
        text += text.empty() ? "" : ", ";
        text += "xyz"[axis];
        text += std::string (" is ") + kWords[row][axes (row, axis) > 0.0];
      }
  return text;
}

/** What is wrong with axes that are the optical ones in another order or direction. */
std::string
axesFault (const Eigen::Matrix3d& axes)
{
  const std::string are = " (" + axesText (axes) + ")";
  if (axes.isDiagonal()) {
    std::vector<std::string> flipped;
    for (int i = 0; i < 3; ++i)
      if (axes (i, i) < 0.0)
        flipped.emplace_back (1, "xyz"[i]);
    if (flipped.size() == 1)
      return flipped[0] + " is mirrored" + are;
    if (flipped.size() == 2)
      return flipped[0] + " and " + flipped[1] + " are flipped" + are;
    return "x, y and z are mirrored" + are;
  }
  const char* const mirrored = axes.determinant() < 0.0 ? ", and mirrored" : "";
  return "this is not the optical frame: " + axesText (axes) + mirrored;
}

/** To a fraction of 1; never -0. */
double
rounded (double value, double parts)
{
  return std::round (value * parts) / parts + 0.0;
}

std::string
vectorText (const Eigen::Vector3d& vector, double parts)
{
  PlainStream text;
  text << "(" << rounded (vector.x(), parts) << ", " << rounded (vector.y(), parts)
       << ", " << rounded (vector.z(), parts) << ")";
  return text.str();
}

/** The camera's place in the cloud's frame; empty when it is the origin. */
std::string
offsetText (const CloudPose& pose, double distance)
{
  const Eigen::Vector3d place = -pose.optical_from_cloud.transpose() * pose.offset;
  if (place.norm() * pose.camera.fx < kTinyPixels * distance)
    return {};
  return "the camera is at " + vectorText (place, 1000.0) + " m of the cloud's frame";
}

/** A typical distance of the points. */
double
typicalDistance (const cv::Mat& points)
{
  double sum = 0.0;
  double n = 0.0;
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u)
      if (const double d = cv::norm (points.at<cv::Vec3f> (v, u)); std::isfinite (d)) {
        sum += d;
        n += 1.0;
      }
  return sum / n;
}

/** The points that are not the origin; every few of them are enough. */
std::vector<Eigen::Vector3d>
someOf (const cv::Mat& points)
{
  constexpr int kSamplesPerSide = 80;
  std::vector<Eigen::Vector3d> some;
  for (int v = 0; v < points.rows; v += std::max (1, points.rows / kSamplesPerSide))
    for (int u = 0; u < points.cols; u += std::max (1, points.cols / kSamplesPerSide)) {
      const auto& p = points.at<cv::Vec3f> (v, u);
      if (std::isfinite (p[0] + p[1] + p[2]) && p != cv::Vec3f())
        some.emplace_back (p[0], p[1], p[2]);
    }
  return some;
}

/** A number that a filter writes where nothing was measured, found at many pixels;
 * empty when there is none. */
std::string
markerFault (std::vector<Eigen::Vector3d> some)
{
  const auto before = [] (const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare (
        a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort (some.begin(), some.end(), before);
  std::size_t most = 0;
  Eigen::Vector3d marker = Eigen::Vector3d::Zero();
  for (std::size_t begin = 0, end = 0; begin < some.size(); begin = end) {
    while (end < some.size() && some[end] == some[begin])
      ++end;
    if (end - begin > most) {
      most = end - begin;
      marker = some[begin];
    }
  }
  if (static_cast<double> (most) < kManyAlike * static_cast<double> (some.size()))
    return {};
  return std::to_string (100 * most / some.size()) + " % of the points are " +
         vectorText (marker, 1000.0) +
         ": write NaN where nothing was measured (pcl::PassThrough does, unless "
         "setUserFilterValue says otherwise)";
}

/** Do they lie in one plane, within a hundredth of their extent? */
bool
areCoplanar (const std::vector<Eigen::Vector3d>& some)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : some)
    mean += p / static_cast<double> (some.size());
  cv::Matx33d spread = cv::Matx33d::zeros();
  for (const Eigen::Vector3d& p : some) {
    const Eigen::Vector3d d = p - mean;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        spread (i, k) += d[i] * d[k];
  }
  cv::Vec3d variances; // descending
  cv::eigen (spread, variances);
  return variances[2] < kFlat * kFlat * variances[1];
}

/** How a frame is turned that is no exchange of axes. */
std::string
turnFault (const Eigen::Matrix3d& optical_from_cloud)
{
  if (optical_from_cloud.determinant() < 0.0)
    return "the cloud is mirrored and rotated against the optical frame";
  const Eigen::Vector3d turn = turnOf (optical_from_cloud.transpose());
  PlainStream text;
  text << "the cloud is rotated by " << rounded (turn.norm() * 180.0 / M_PI, 10.0)
       << " degrees about " << vectorText (turn / std::max (turn.norm(), 1e-12), 10.0)
       << " against the optical frame";
  return text.str();
}

/** What an explaining pose says; empty when the cloud lies in the optical frame. */
std::string
poseFault (const CloudPose& pose, double distance)
{
  const Eigen::Matrix3d& rotation = pose.optical_from_cloud;
  const Eigen::Matrix3d axes = nearestAxes (rotation);
  const bool comparable = axes.determinant() * rotation.determinant() > 0.0;
  const double tilt = comparable ? degreesBetween (rotation, axes) : 180.0;
  std::string fault;
  if (!axes.isIdentity (0.0) && tilt < kAxesDegrees)
    fault = axesFault (axes);
  else if (tilt > kTinyDegrees)
    fault = turnFault (rotation);
  const std::string place = offsetText (pose, distance);
  if (place.empty())
    return fault;
  if (fault.empty())
    return "the cloud was moved, to a map's frame perhaps: " + place;
  return fault + "; " + place;
}

std::string
cameraFault (const PinholeCamera& own, const PinholeCamera& expected)
{
  PlainStream text;
  text << "the points' own camera is " << cameraText (own);
  const double scale = own.fx / expected.fx;
  if (std::abs (own.fy / expected.fy / scale - 1.0) > kSameScale)
    text << ": another camera's?";
  else if (std::abs (scale - 1.0) > kSameScale)
    text << ", " << scale
         << " times the focal length: another resolution's or another camera's?";
  else
    text << ": another principal point, or a moved cloud?";
  return text.str();
}

/** The pose with fewer unknowns unless the other one is much better. */
CloudPose
likelyPose (const cv::Mat& points)
{
  const CloudPose simple = poseByAxes (points);
  if (simple.error < kTinyPixels)
    return simple;
  const CloudPose general = poseByProjection (points);
  return general.error < kMuchBetter * simple.error ? general : simple;
}

} // namespace

std::string
cameraText (const PinholeCamera& camera)
{
  PlainStream text;
  text << "fx " << camera.fx << ", fy " << camera.fy << ", cx " << camera.cx << ", cy "
       << camera.cy;
  return text.str();
}

std::string
causeOfMisfit (const cv::Mat& points, const PinholeCamera* camera)
{
  const CloudPose pose = likelyPose (points);
  if (!(pose.error <= kExplained)) {
    const std::vector<Eigen::Vector3d> some = someOf (points);
    if (std::string marker = markerFault (some); !marker.empty())
      return marker;
    if (areCoplanar (some))
      return "the cloud was moved or turned, or another camera saw it: all points lie "
             "in one plane, which does not determine how" +
             std::string (kTransformBack);
    return "this is no pinhole image in a camera's optical frame (x right, y down, z "
           "forward), and the points don't tell why: a spinning lidar, a fisheye, an "
           "unrectified image?";
  }
  const std::string fault = poseFault (pose, typicalDistance (points));
  if (!fault.empty())
    return fault + kTransformBack;
  if (camera)
    return cameraFault (pose.camera, *camera);
  return "too many of them are wrong, in x, y or z";
}

} // namespace pcl_msf
