// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <synthetic/part_view.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_msf {
namespace synthetic {
namespace {

constexpr int cells = 48;     ///< of the start mesh, per axis
constexpr double bin = 8.0;   ///< pixels
constexpr double margin = .4; ///< how far beyond its triangle a start is tried

using Triangle = std::array<int, 3>;

/** A place on the surface and its tangents, camera coordinates. */
struct Tangents {
  Eigen::Vector3d point, du, dv;

  Eigen::Vector3d
  normal () const
  {
    return du.cross (dv).normalized();
  }
};

class SoftView : public PartView {
public:
  SoftView (const SoftSurface& surface,
            const Eigen::Isometry3d& camera_from_part,
            const PinholeCamera& camera,
            double phase)
  : surface_ (surface)
  , rotation_ (camera_from_part.linear())
  , translation_ (camera_from_part.translation())
  , camera_ (camera)
  , phase_ (phase)
  {
    makeMesh();
    fillBins();
  }

  bool
  cast (const Eigen::Vector3d& direction, double limit, ViewHit& hit) const override;

  Eigen::Matrix3d
  materialFromCamera (const ViewHit& hit) const override
  {
    const Tangents t = tangents (hit.material.x(), hit.material.y());
    Eigen::Matrix3d camera_from_material;
    camera_from_material << t.du, t.dv, t.normal();
    Eigen::Matrix3d inverse = camera_from_material.inverse();
    inverse.row (2).setZero();
    return inverse;
  }

  Eigen::Vector3d
  place (const Eigen::Vector3d& material) const override
  {
    return rotation_ * surface_.place (material.x(), material.y(), phase_) +
           translation_;
  }

  Eigen::Vector3d
  restNormal (const ViewHit& hit) const override
  {
    constexpr double h = 1e-5;
    const double u = hit.material.x(), v = hit.material.y();
    const Eigen::Vector3d p = surface_.place (u, v, 0.0);
    const Eigen::Vector3d du = surface_.place (u + h, v, 0.0) - p;
    const Eigen::Vector3d n = du.cross (surface_.place (u, v + h, 0.0) - p);
    const bool back = hit.normal.dot (tangents (u, v).normal()) < 0.0;
    return (back ? -n : n).normalized();
  }

  cv::Rect2d
  bounds () const override
  {
    return bounds_;
  }

private:
  void
  makeMesh ();

  void
  fillBins ();

  cv::Rect2d
  triangleBounds (const Triangle& triangle) const;

  bool
  startIn (const Triangle& triangle,
           const Eigen::Vector3d& direction,
           Eigen::Vector3d& uvs) const;

  bool
  refine (const Eigen::Vector3d& direction, Eigen::Vector3d& uvs) const;

  Tangents
  tangents (double u, double v) const
  {
    constexpr double h = 1e-6; // central: exact to 1e-11
    const auto at = [&] (double a, double b) { return surface_.place (a, b, phase_); };
    return {rotation_ * at (u, v) + translation_,
            rotation_ * (at (u + h, v) - at (u - h, v)) / (2.0 * h),
            rotation_ * (at (u, v + h) - at (u, v - h)) / (2.0 * h)};
  }

  const SoftSurface& surface_;
  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_;
  PinholeCamera camera_;
  double phase_;
  std::vector<Eigen::Vector3d> points_; ///< of the mesh, camera coordinates
  std::vector<Eigen::Vector2d> uv_;
  std::vector<Triangle> triangles_;
  cv::Rect2d bounds_;
  int columns_{0}, rows_{0};
  std::vector<std::vector<int>> bins_; ///< triangles that may cover an image square
};

void
SoftView::makeMesh()
{
  const Eigen::Vector2d half = surface_.halfSize();
  const int side = cells + 1;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      uv_.emplace_back (half.x() * (2.0 * i / cells - 1.0),
                        half.y() * (2.0 * j / cells - 1.0));
      points_.push_back (place ({uv_.back().x(), uv_.back().y(), 0.0}));
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * side + i;
      triangles_.push_back ({a, a + 1, a + side});
      triangles_.push_back ({a + 1, a + side + 1, a + side});
    }
}

cv::Rect2d
SoftView::triangleBounds (const Triangle& triangle) const
{
  Eigen::Vector2d low (1e9, 1e9), high (-1e9, -1e9);
  for (const int i : triangle) {
    if (points_[i].z() < 1e-3)
      return {};
    const Eigen::Vector2d p = camera_.project (points_[i]);
    low = low.cwiseMin (p);
    high = high.cwiseMax (p);
  }
  const Eigen::Vector2d grown = margin * (high - low) + Eigen::Vector2d (2.0, 2.0);
  low -= grown;
  high += grown;
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

void
SoftView::fillBins()
{
  std::vector<cv::Rect2d> boxes;
  for (const Triangle& triangle : triangles_) {
    boxes.push_back (triangleBounds (triangle));
    bounds_ = bounds_.empty() ? boxes.back() : bounds_ | boxes.back();
  }
  // What is far outside of any image gets no bins of its own.
  const double size = 3.0 * std::max (camera_.cx, camera_.cy) + 100.0;
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

bool
SoftView::startIn (const Triangle& triangle,
                   const Eigen::Vector3d& direction,
                   Eigen::Vector3d& uvs) const
{
  const Eigen::Vector3d& a = points_[triangle[0]];
  const Eigen::Vector3d ab = points_[triangle[1]] - a, ac = points_[triangle[2]] - a;
  const Eigen::Vector3d side = direction.cross (ac);
  const double determinant = ab.dot (side);
  if (determinant == 0.0)
    return false;
  const double b = -a.dot (side) / determinant;
  const Eigen::Vector3d across = ab.cross (a);
  const double c = direction.dot (across) / determinant;
  if (b < -margin || c < -margin || b + c > 1.0 + margin)
    return false;
  const Eigen::Vector2d uv = uv_[triangle[0]] +
                             b * (uv_[triangle[1]] - uv_[triangle[0]]) +
                             c * (uv_[triangle[2]] - uv_[triangle[0]]);
  uvs = {uv.x(), uv.y(), ac.dot (across) / determinant};
  return uvs.z() > 0.0;
}

/** Newton's method for place (u, v) = s direction. */
bool
SoftView::refine (const Eigen::Vector3d& direction, Eigen::Vector3d& uvs) const
{
  const double reach = 3.0 * surface_.halfSize().maxCoeff() / cells;
  const Eigen::Vector2d start = uvs.head<2>();
  for (int i = 0; i < 8; ++i) {
    const Tangents t = tangents (uvs.x(), uvs.y());
    const Eigen::Vector3d error = t.point - uvs.z() * direction;
    if (error.squaredNorm() < 1e-22)
      return true;
    Eigen::Matrix3d jacobian;
    jacobian << t.du, t.dv, -direction;
    const double determinant = jacobian.determinant();
    if (std::abs (determinant) < 1e-9)
      return false;
    uvs -= jacobian.inverse() * error;
    if (!((uvs.head<2>() - start).norm() < reach))
      return false;
  }
  return false;
}

bool
SoftView::cast (const Eigen::Vector3d& direction, double limit, ViewHit& hit) const
{
  const Eigen::Vector2d pixel = camera_.project (direction);
  const double x = (pixel.x() - bounds_.x) / bin, y = (pixel.y() - bounds_.y) / bin;
  if (!(x >= 0.0 && y >= 0.0 && x < columns_ && y < rows_))
    return false;
  const Eigen::Vector2d half = surface_.halfSize();
  bool found = false;
  Eigen::Vector3d best (0.0, 0.0, limit);
  for (const int t : bins_[static_cast<int> (y) * columns_ + static_cast<int> (x)]) {
    Eigen::Vector3d uvs;
    if (!startIn (triangles_[t], direction, uvs) || uvs.z() > 1.05 * best.z())
      continue;
    // Neighbouring triangles lead to the same place.
    const double same = 0.5 * half.maxCoeff() / cells;
    if (found && (uvs - best).norm() < same)
      continue;
    if (!refine (direction, uvs) || !(uvs.z() > 0.0 && uvs.z() < best.z()) ||
        std::abs (uvs.x()) > half.x() || std::abs (uvs.y()) > half.y())
      continue;
    best = uvs;
    found = true;
  }
  if (!found)
    return false;
  hit.depth = best.z();
  hit.material = {best.x(), best.y(), 0.0};
  const Eigen::Vector3d n = tangents (best.x(), best.y()).normal();
  hit.normal = n.dot (direction) > 0.0 ? -n : n;
  return true;
}

} // namespace

std::unique_ptr<PartView>
makeSoftView (const SoftSurface& surface,
              const Eigen::Isometry3d& camera_from_part,
              const PinholeCamera& camera,
              double phase)
{
  return std::make_unique<SoftView> (surface, camera_from_part, camera, phase);
}

} // namespace synthetic
} // namespace pcl_msf
