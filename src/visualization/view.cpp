// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/view.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_msf::visualization {

namespace {

constexpr double kRadians = 3.14159265358979323846 / 180.0;
constexpr double kFill = 0.85;        ///< a box looks smaller than the sphere around it
constexpr double kLeastRadius = 1e-3; ///< metres: a single point has a picture, too

PinholeCamera
centredCamera (const cv::Size& size, double field_of_view)
{
  const double side = std::max (size.width, size.height);
  const double focal = 0.5 * side / std::tan (0.5 * field_of_view * kRadians);
  return {focal, focal, 0.5 * (size.width - 1.0), 0.5 * (size.height - 1.0)};
}

/** Looks along `forward` with the picture's lower side towards `down`. */
Eigen::Matrix3d
lookAlong (const Eigen::Vector3d& forward, const Eigen::Vector3d& down)
{
  Eigen::Matrix3d rotation;
  const Eigen::Vector3d z = forward.normalized();
  const Eigen::Vector3d x = down.cross (z).normalized();
  rotation.row (0) = x;
  rotation.row (1) = z.cross (x);
  rotation.row (2) = z;
  return rotation;
}

/** How far from its centre the scene has to be seen from to fill the picture. */
double
viewingDistance (const SceneBounds& bounds, const View& view, double zoom)
{
  const double side = std::min (view.size.width, view.size.height);
  const double half_angle = std::atan (0.5 * side / view.camera.fx);
  return kFill * bounds.radius / std::sin (half_angle) / zoom;
}

} // namespace

Eigen::Vector2d
View::project (const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d p = toView (point);
  if (parallel)
    return {scale * p.x() + camera.cx, scale * p.y() + camera.cy};
  if (!(p.z() > 0.0))
    return Eigen::Vector2d::Constant (std::numeric_limits<double>::quiet_NaN());
  return camera.project (p);
}

View
View::resized (const cv::Size& picture) const
{
  const double ratio = std::min (picture.width / static_cast<double> (size.width),
                                 picture.height / static_cast<double> (size.height));
  View view = *this;
  view.size = picture;
  view.scale *= ratio;
  view.camera.fx *= ratio;
  view.camera.fy *= ratio;
  // An image of width w covers [-0.5, w - 0.5]: its middle is at (w - 1) / 2.
  view.camera.cx =
      0.5 * (picture.width - 1.0) + ratio * (camera.cx - 0.5 * (size.width - 1.0));
  view.camera.cy =
      0.5 * (picture.height - 1.0) + ratio * (camera.cy - 0.5 * (size.height - 1.0));
  return view;
}

SceneBounds
boundsOf (const cv::Mat& points)
{
  CV_Assert (points.type() == CV_32FC3);
  std::vector<float> axis[3];
  for (int row = 0; row < points.rows; ++row)
    for (int col = 0; col < points.cols; ++col) {
      const auto& p = points.at<cv::Vec3f> (row, col);
      for (int c = 0; c < 3 && std::isfinite (p[0] + p[1] + p[2]); ++c)
        axis[c].push_back (p[c]);
    }
  SceneBounds bounds;
  if (axis[0].empty())
    return bounds;
  Eigen::Vector3d low, high;
  for (int c = 0; c < 3; ++c) {
    std::sort (axis[c].begin(), axis[c].end());
    const auto last = static_cast<double> (axis[c].size() - 1);
    low[c] = axis[c][static_cast<std::size_t> (0.02 * last)];
    high[c] = axis[c][static_cast<std::size_t> (0.98 * last)];
  }
  bounds.center = 0.5 * (low + high);
  bounds.radius = std::max (0.5 * (high - low).norm(), kLeastRadius);
  bounds.distance = bounds.center.norm();
  return bounds;
}

View
sensorView (const PinholeCamera& camera, const cv::Size& size)
{
  View view;
  view.camera = camera;
  view.size = size;
  return view;
}

View
orbitView (const SceneBounds& bounds,
           const cv::Size& size,
           double azimuth,
           double elevation,
           double field_of_view,
           double zoom)
{
  View view;
  view.size = size;
  view.camera = centredCamera (size, field_of_view);
  const double a = azimuth * kRadians;
  const double e = std::clamp (elevation, -89.0, 89.0) * kRadians;
  // From the sensor's side (-z), to the right (+x), upwards (-y).
  const Eigen::Vector3d away (
      std::sin (a) * std::cos (e), -std::sin (e), -std::cos (a) * std::cos (e));
  view.rotation = lookAlong (-away, Eigen::Vector3d::UnitY());
  view.position = bounds.center + viewingDistance (bounds, view, zoom) * away;
  return view;
}

View
topView (const SceneBounds& bounds,
         const cv::Size& size,
         double field_of_view,
         double zoom)
{
  View view;
  view.size = size;
  view.camera = centredCamera (size, field_of_view);
  view.rotation = lookAlong (Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ());
  view.position =
      bounds.center - viewingDistance (bounds, view, zoom) * Eigen::Vector3d::UnitY();
  return view;
}

View
userView (const Eigen::Vector3d& eye,
          const Eigen::Vector3d& target,
          const Eigen::Vector3d& up,
          const cv::Size& size,
          double field_of_view)
{
  const Eigen::Vector3d forward = target - eye;
  if (!(forward.norm() > 0.0))
    throw InvalidInput ("view: eye and target are one point; move one of them");
  if (!(forward.normalized().cross (up).norm() > 1e-6))
    throw InvalidInput ("view: up is along the line of sight; choose another");
  View view;
  view.size = size;
  view.camera = centredCamera (size, field_of_view);
  view.rotation = lookAlong (forward, -up);
  view.position = eye;
  return view;
}

View
parallelView (const View& perspective, double distance)
{
  View view = perspective;
  view.parallel = true;
  view.scale = perspective.camera.fx / std::max (distance, 1e-9);
  return view;
}

} // namespace pcl_msf::visualization
