// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::visualization {

namespace {

constexpr double kArrowRadius = 0.25; ///< no arrow is thicker, in shares of its size

/** Collects depths of points. */
class Range {
public:
  explicit Range (const View& view) : view_ (view) {}

  void
  add (const cv::Vec3f& p, double around = 0.0)
  {
    const double z = view_.toView ({p[0], p[1], p[2]}).z();
    if (!std::isfinite (z) || !std::isfinite (around))
      return;
    low_ = std::min (low_, z - around);
    high_ = std::max (high_, z + around);
  }
  DepthRange
  result () const
  {
    if (!(low_ <= high_))
      return {0.1, 10.0};
    const double margin = 0.01 * (high_ - low_) + 1e-3;
    if (view_.parallel)
      return {low_ - margin, high_ + margin};
    const double far = std::max (high_ + margin, 1e-2);
    return {std::clamp (low_ - margin, 1e-3 * far, 0.99 * far), far};
  }

private:
  const View& view_;
  double low_{std::numeric_limits<double>::infinity()};
  double high_{-std::numeric_limits<double>::infinity()};
};

} // namespace

DepthRange
depthRange (const Scene& scene, const View& view)
{
  Range range (view);
  for (const PointSet& set : scene.points)
    for (int row = 0; row < set.positions.rows; ++row)
      for (int col = 0; col < set.positions.cols; ++col)
        range.add (set.positions.at<cv::Vec3f> (row, col));
  for (const Arrow& arrow : scene.arrows) {
    const double thick =
        std::min (cv::norm (arrow.to - arrow.from), double{arrow.thickest});
    range.add (arrow.from, kArrowRadius * thick);
    range.add (arrow.to, kArrowRadius * thick);
  }
  for (const Polyline& line : scene.lines)
    for (const cv::Vec3f& p : line.points)
      range.add (p);
  return range.result();
}

Eigen::Matrix4d
projectionMatrix (const View& view, const DepthRange& range)
{
  // Pixel u covers [u - 0.5, u + 0.5]: the picture's left edge, -1 in OpenGL, is -0.5.
  const double w = view.size.width;
  const double h = view.size.height;
  const double x = 2.0 * (view.camera.cx + 0.5) / w - 1.0;
  const double y = 1.0 - 2.0 * (view.camera.cy + 0.5) / h;
  const double depth = range.far - range.near;
  const double sum = range.far + range.near;
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  if (view.parallel) {
    m (0, 0) = 2.0 * view.scale / w;
    m (0, 3) = x;
    m (1, 1) = 2.0 * view.scale / h;
    m (1, 3) = y;
    m (2, 2) = -2.0 / depth;
    m (2, 3) = -sum / depth;
    m (3, 3) = 1.0;
    return m;
  }
  m (0, 0) = 2.0 * view.camera.fx / w;
  m (0, 2) = -x;
  m (1, 1) = 2.0 * view.camera.fy / h;
  m (1, 2) = -y;
  m (2, 2) = -sum / depth;
  m (2, 3) = -2.0 * range.far * range.near / depth;
  m (3, 2) = -1.0;
  return m;
}

} // namespace pcl_msf::visualization
