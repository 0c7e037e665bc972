// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/shape.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

/** Smaller root of a s^2 + 2 b s + c = 0 when it lies in (0, limit). */
bool
nearRoot (double a, double b, double c, double limit, double& s)
{
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || a <= 0.0)
    return false;
  const double root = std::sqrt (discriminant);
  // The form without cancellation.
  s = b <= 0.0 ? c / (-b + root) : (-b - root) / a;
  return s > 0.0 && s < limit;
}

class EllipsoidShape : public Shape {
public:
  explicit EllipsoidShape (const Eigen::Vector3d& axes)
  : axes_ (axes), inverse_ (axes.cwiseInverse())
  {}

  bool
  intersect (const Ray& ray, double limit, ShapeHit& hit) const override
  {
    const Eigen::Vector3d o = ray.origin.cwiseProduct (inverse_);
    const Eigen::Vector3d d = ray.direction.cwiseProduct (inverse_);
    const double c = o.squaredNorm() - 1.0;
    if (!nearRoot (d.squaredNorm(), o.dot (d), c, limit, hit.s))
      return false;
    hit.normal = (o + hit.s * d).cwiseProduct (inverse_).normalized();
    return true;
  }

  double
  radius () const override
  {
    return axes_.maxCoeff();
  }

private:
  Eigen::Vector3d axes_, inverse_;
};

bool
intersectSphere (const Ray& ray, double z, double r, double limit, ShapeHit& hit)
{
  const Eigen::Vector3d o = ray.origin - Eigen::Vector3d (0.0, 0.0, z);
  if (!nearRoot (ray.direction.squaredNorm(),
                 o.dot (ray.direction),
                 o.squaredNorm() - r * r,
                 limit,
                 hit.s))
    return false;
  hit.normal = (o + hit.s * ray.direction) / r;
  return true;
}

/** The wall of a cylinder around z, between two heights. */
bool
intersectWall (
    const Ray& ray, double low, double high, double r, double limit, ShapeHit& hit)
{
  const Eigen::Vector2d o = ray.origin.head<2>(), d = ray.direction.head<2>();
  if (!nearRoot (d.squaredNorm(), o.dot (d), o.squaredNorm() - r * r, limit, hit.s))
    return false;
  const Eigen::Vector3d p = ray.at (hit.s);
  if (p.z() < low || p.z() > high)
    return false;
  hit.normal = {p.x() / r, p.y() / r, 0.0};
  return true;
}

class CapsuleShape : public Shape {
public:
  CapsuleShape (double length, double radius) : length_ (length), radius_ (radius) {}

  bool
  intersect (const Ray& ray, double limit, ShapeHit& hit) const override
  {
    ShapeHit part;
    bool found = false;
    const auto keep = [&] (bool ok) {
      if (ok) {
        hit = part;
        limit = part.s;
        found = true;
      }
    };
    keep (intersectWall (ray, 0.0, length_, radius_, limit, part));
    keep (intersectSphere (ray, 0.0, radius_, limit, part));
    keep (intersectSphere (ray, length_, radius_, limit, part));
    return found;
  }

  double
  radius () const override
  {
    return length_ + radius_;
  }

private:
  double length_, radius_;
};

class CylinderShape : public Shape {
public:
  CylinderShape (double half_length, double radius)
  : half_length_ (half_length), radius_ (radius)
  {}

  bool
  intersect (const Ray& ray, double limit, ShapeHit& hit) const override
  {
    if (intersectWall (ray, -half_length_, half_length_, radius_, limit, hit))
      return true; // the rays' origins are outside, so a wall hides its cap
    const double d = ray.direction.z();
    if (d == 0.0)
      return false;
    const double side = d > 0.0 ? -1.0 : 1.0;
    const double s = (side * half_length_ - ray.origin.z()) / d;
    if (!(s > 0.0 && s < limit) || ray.at (s).head<2>().norm() > radius_)
      return false;
    hit.s = s;
    hit.normal = {0.0, 0.0, side};
    return true;
  }

  double
  radius () const override
  {
    return std::hypot (half_length_, radius_);
  }

private:
  double half_length_, radius_;
};

} // namespace

ShapePtr
makeEllipsoid (const Eigen::Vector3d& axes)
{
  return std::make_shared<EllipsoidShape> (axes);
}

ShapePtr
makeCapsule (double length, double radius)
{
  return std::make_shared<CapsuleShape> (length, radius);
}

ShapePtr
makeCylinder (double half_length, double radius)
{
  return std::make_shared<CylinderShape> (half_length, radius);
}

} // namespace pcl_msf::synthetic
