// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/shape.h>

#include <cmath>
#include <limits>

namespace pcl_msf::synthetic {
namespace {

/** Where a ray is inside a box, and the faces where it enters and leaves. */
struct Slabs {
  double enter{-std::numeric_limits<double>::infinity()};
  double leave{std::numeric_limits<double>::infinity()};
  int enter_axis{0};
  int leave_axis{0};
};

/** False when the ray misses. */
bool
crossSlabs (const Ray& ray, const Eigen::Vector3d& half, Slabs& slabs)
{
  for (int a = 0; a < 3; ++a) {
    const double o = ray.origin[a], d = ray.direction[a];
    if (d == 0.0) {
      if (std::abs (o) > half[a])
        return false;
      continue;
    }
    const double side = d > 0.0 ? half[a] : -half[a];
    const double near = (-side - o) / d, far = (side - o) / d;
    if (near > slabs.enter) {
      slabs.enter = near;
      slabs.enter_axis = a;
    }
    if (far < slabs.leave) {
      slabs.leave = far;
      slabs.leave_axis = a;
    }
  }
  return slabs.enter <= slabs.leave;
}

class BoxShape : public Shape {
public:
  BoxShape (const Eigen::Vector3d& half, bool inside) : half_ (half), inside_ (inside)
  {}

  bool
  intersect (const Ray& ray, double limit, ShapeHit& hit) const override
  {
    Slabs slabs;
    if (!crossSlabs (ray, half_, slabs))
      return false;
    const double s = inside_ ? slabs.leave : slabs.enter;
    if (!(s > 0.0 && s < limit))
      return false;
    const int axis = inside_ ? slabs.leave_axis : slabs.enter_axis;
    hit.s = s;
    hit.normal.setZero();
    hit.normal[axis] = ray.direction[axis] > 0.0 ? -1.0 : 1.0;
    return true;
  }

  double
  radius () const override
  {
    return half_.norm();
  }

private:
  Eigen::Vector3d half_;
  bool inside_;
};

} // namespace

ShapePtr
makeBox (const Eigen::Vector3d& half)
{
  return std::make_shared<BoxShape> (half, false);
}

ShapePtr
makeRoom (const Eigen::Vector3d& half)
{
  return std::make_shared<BoxShape> (half, true);
}

} // namespace pcl_msf::synthetic
