// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include <synthetic/start_mesh.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr int cells = 48;      ///< per axis
constexpr double bin = 8.0;    ///< pixels
constexpr double margin = 0.4; ///< how far beyond its triangle a start is offered

} // namespace

StartMesh::StartMesh (const SoftForm& form,
                      const Eigen::Vector2d& half,
                      const Eigen::Matrix3d& rotation,
                      const Eigen::Vector3d& translation,
                      const PinholeCamera& camera)
: camera_ (camera), cell_size_ (2.0 * half.maxCoeff() / cells)
{
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const Eigen::Vector2d uv (half.x() * (2.0 * i / cells - 1.0),
                                half.y() * (2.0 * j / cells - 1.0));
      vertices_.push_back ({uv, rotation * form.place (uv.x(), uv.y()) + translation});
    }
  makeTriangles();
  fillBins();
}

void
StartMesh::makeTriangles()
{
  const int side = cells + 1;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * side + i;
      triangles_.push_back ({a, a + 1, a + side});
      triangles_.push_back ({a + 1, a + side + 1, a + side});
    }
}

cv::Rect2d
StartMesh::boundsOf (const Triangle& triangle) const
{
  Eigen::Vector2d low (1e9, 1e9), high (-1e9, -1e9);
  for (const int i : triangle) {
    const Eigen::Vector3d& point = vertices_[i].point;
    if (point.z() < 1e-3)
      return {};
    const Eigen::Vector2d p = camera_.project (point);
    low = low.cwiseMin (p);
    high = high.cwiseMax (p);
  }
  const Eigen::Vector2d grown = margin * (high - low) + Eigen::Vector2d (2.0, 2.0);
  low -= grown;
  high += grown;
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

void
StartMesh::fillBins()
{
  std::vector<cv::Rect2d> boxes;
  for (const Triangle& triangle : triangles_) {
    boxes.push_back (boundsOf (triangle));
    bounds_ = bounds_.empty() ? boxes.back() : bounds_ | boxes.back();
  }
  // What is far outside of any image gets no bins.
  const double size = 3.0 * std::max ({camera_.cx, camera_.cy, camera_.fx}) + 100.0;
  bounds_ &= cv::Rect2d (-size, -size, 3.0 * size, 3.0 * size);
  columns_ = static_cast<int> (bounds_.width / bin) + 1;
  rows_ = static_cast<int> (bounds_.height / bin) + 1;
  bins_.resize (static_cast<std::size_t> (columns_) * rows_);
  const auto index = [] (double x, double low, int count) {
    return std::clamp (static_cast<int> ((x - low) / bin), 0, count - 1);
  };
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    const cv::Rect2d box = boxes[t] & bounds_;
    if (box.empty())
      continue;
    const int right = index (box.x + box.width, bounds_.x, columns_);
    const int bottom = index (box.y + box.height, bounds_.y, rows_);
    for (int r = index (box.y, bounds_.y, rows_); r <= bottom; ++r)
      for (int c = index (box.x, bounds_.x, columns_); c <= right; ++c)
        bins_[r * columns_ + c].push_back (static_cast<int> (t));
  }
}

/** The ray's intersection with the triangle's plane, in or near the triangle. */
bool
StartMesh::startIn (const Triangle& triangle,
                    const Eigen::Vector3d& direction,
                    Eigen::Vector3d& start) const
{
  const Vertex& first = vertices_[triangle[0]];
  const Vertex& second = vertices_[triangle[1]];
  const Vertex& third = vertices_[triangle[2]];
  const Eigen::Vector3d ab = second.point - first.point;
  const Eigen::Vector3d ac = third.point - first.point;
  const Eigen::Vector3d side = direction.cross (ac);
  const double determinant = ab.dot (side);
  if (determinant == 0.0)
    return false;
  const double b = -first.point.dot (side) / determinant;
  if (b < -margin || b > 1.0 + 2.0 * margin)
    return false;
  const Eigen::Vector3d across = ab.cross (first.point);
  const double c = direction.dot (across) / determinant;
  if (c < -margin || b + c > 1.0 + margin)
    return false;
  start.head<2>() = first.uv + b * (second.uv - first.uv) + c * (third.uv - first.uv);
  start.z() = ac.dot (across) / determinant;
  return start.z() > 0.0;
}

void
StartMesh::startsFor (const Eigen::Vector3d& direction,
                      std::vector<Eigen::Vector3d>& starts) const
{
  starts.clear();
  const Eigen::Vector2d pixel = camera_.project (direction);
  const double x = (pixel.x() - bounds_.x) / bin, y = (pixel.y() - bounds_.y) / bin;
  if (!(x >= 0.0 && y >= 0.0 && x < columns_ && y < rows_))
    return;
  Eigen::Vector3d start;
  for (const int t : bins_[static_cast<int> (y) * columns_ + static_cast<int> (x)])
    if (startIn (triangles_[t], direction, start))
      starts.push_back (start);
  std::sort (starts.begin(),
             starts.end(),
             [] (const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
               return a.z() < b.z();
             });
}

} // namespace pcl_msf::synthetic
