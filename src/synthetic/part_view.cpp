// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/part_view.h>

#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr double everywhere = 1e9;

/** Pixels between the two tangents from the camera to a disc, along one image axis. */
cv::Vec2d
tangentRange (double x, double z, double radius, double f, double c)
{
  const double distance = std::hypot (x, z);
  if (distance <= radius)
    return {-everywhere, everywhere};
  const double middle = std::atan2 (x, z);
  const double half = std::asin (radius / distance);
  const double limit = 0.5 * M_PI - 1e-6;
  const double low = middle - half, high = middle + half;
  if (low >= limit || high <= -limit)
    return {everywhere, -everywhere}; // behind
  return {low <= -limit ? -everywhere : f * std::tan (low) + c,
          high >= limit ? everywhere : f * std::tan (high) + c};
}

class RigidView : public PartView {
public:
  RigidView (const Shape& shape,
             const Isometry& camera_from_part,
             const PinholeCamera& camera)
  : shape_ (shape)
  , rotation_ (camera_from_part.linear())
  , translation_ (camera_from_part.translation())
  , origin_ (-(rotation_.transpose() * translation_))
  , bounds_ (sphereBounds (translation_, shape.radius(), camera))
  {}

  bool
  cast (const Eigen::Vector3d& direction, double limit, ViewHit& hit) const override
  {
    const Ray ray{origin_, rotation_.transpose() * direction};
    ShapeHit on_shape;
    if (!shape_.intersect (ray, limit, on_shape))
      return false;
    hit.depth = on_shape.s;
    hit.material = ray.at (on_shape.s);
    hit.normal = rotation_ * on_shape.normal;
    return true;
  }

  Eigen::Matrix3d
  materialFromCamera (const ViewHit&) const override
  {
    return rotation_.transpose();
  }

  Eigen::Vector3d
  place (const Eigen::Vector3d& material) const override
  {
    return rotation_ * material + translation_;
  }

  Eigen::Vector3d
  restNormal (const ViewHit& hit) const override
  {
    return rotation_.transpose() * hit.normal;
  }

  cv::Rect2d
  bounds () const override
  {
    return bounds_;
  }

private:
  const Shape& shape_;
  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_, origin_;
  cv::Rect2d bounds_;
};

} // namespace

cv::Rect2d
sphereBounds (const Eigen::Vector3d& center, double radius, const PinholeCamera& camera)
{
  const cv::Vec2d u =
      tangentRange (center.x(), center.z(), radius, camera.fx, camera.cx);
  const cv::Vec2d v =
      tangentRange (center.y(), center.z(), radius, camera.fy, camera.cy);
  if (u[0] > u[1] || v[0] > v[1])
    return {};
  return {u[0] - 1.0, v[0] - 1.0, u[1] - u[0] + 2.0, v[1] - v[0] + 2.0};
}

std::unique_ptr<PartView>
makePartView (const Part& part,
              const Motion& world_from_body,
              const Isometry& camera_from_world,
              const PinholeCamera& camera,
              double phase)
{
  const Isometry camera_from_part =
      camera_from_world * world_from_body (phase) * part.body_from_part;
  if (part.soft)
    return makeSoftView (*part.soft, camera_from_part, camera, phase);
  return std::make_unique<RigidView> (*part.shape, camera_from_part, camera);
}

} // namespace pcl_msf::synthetic
