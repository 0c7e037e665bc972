// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/body_shapes.h>

namespace pcl_msf::synthetic {
namespace {

using Eigen::Vector3d;

BodyLink
root (const Vector3d& center, const Vector3d& half)
{
  BodyLink link;
  link.center = center;
  link.half = half;
  return link;
}

/** A link from its joint along a direction of the axes; it begins a little before the
 * joint, so that the surface stays closed as it turns. */
BodyLink
limb (int parent,
      const Vector3d& joint,
      const Vector3d& direction,
      double length,
      const Vector3d& half_across,
      const Vector3d& axis)
{
  BodyLink link;
  link.parent = parent;
  link.joint = joint;
  link.axis = axis.normalized();
  const double before = half_across.maxCoeff();
  link.center = joint + 0.5 * (length - before) * direction;
  link.half = half_across + 0.5 * (length + before) * direction.cwiseAbs();
  return link;
}

std::vector<BodyLink>
chainLinks ()
{
  const Vector3d half (0.0, 0.1, 0.07);
  std::vector<BodyLink> links{root ({0.2, 0.0, 0.0}, {0.2, 0.11, 0.08})};
  for (int k = 1; k < 4; ++k)
    links.push_back (
        limb (k - 1,
              {0.4 * k, 0.0, 0.0},
              Vector3d::UnitX(),
              0.4,
              (1.0 - 0.08 * k) * half,
              k % 2 == 1 ? Vector3d (0.1, 0.2, 1.0) : Vector3d (0.0, 1.0, -0.2)));
  return links;
}

std::vector<BodyLink>
handLinks ()
{
  std::vector<BodyLink> links{root ({0.0, 0.0, 0.0}, {0.24, 0.26, 0.06})};
  const auto finger = [&links] (const Vector3d& joint,
                                const Vector3d& direction,
                                double length,
                                const Vector3d& half,
                                const Vector3d& axis) {
    links.push_back (limb (0, joint, direction, length, half, axis));
    links.push_back (limb (static_cast<int> (links.size()) - 1,
                           joint + length * direction,
                           direction,
                           0.8 * length,
                           0.85 * half,
                           axis));
  };
  for (int f = 0; f < 4; ++f)
    finger ({0.24, -0.2 + 0.135 * f, 0.0},
            Vector3d::UnitX(),
            f == 3 ? 0.17 : 0.22 - 0.02 * (f % 2),
            {0.0, 0.045, 0.035},
            {0.0, 1.0, 0.15});
  finger (
      {-0.1, -0.26, 0.0}, -Vector3d::UnitY(), 0.2, {0.05, 0.0, 0.04}, {1.0, 0.1, 0.5});
  return links;
}

std::vector<BodyLink>
animalLinks ()
{
  std::vector<BodyLink> links{root ({0.0, 0.0, 0.0}, {0.42, 0.14, 0.17})};
  const Vector3d down = -Vector3d::UnitZ();
  for (const double x : {0.34, -0.34})
    for (const double y : {0.1, -0.1}) {
      const double front = x > 0.0 ? 1.0 : 1.12;
      links.push_back (limb (0,
                             {x, y, -0.12},
                             down,
                             0.27,
                             front * Vector3d (0.07, 0.05, 0.0),
                             {0.1, 1.0, 0.0}));
      links.push_back (limb (static_cast<int> (links.size()) - 1,
                             {x, y, -0.39},
                             down,
                             0.26,
                             front * Vector3d (0.05, 0.036, 0.0),
                             {0.0, 1.0, 0.1}));
    }
  links.push_back (limb (0,
                         {0.36, 0.0, 0.1},
                         Vector3d::UnitZ(),
                         0.34,
                         {0.09, 0.07, 0.0},
                         {0.2, 1.0, 0.0}));
  links.push_back (limb (static_cast<int> (links.size()) - 1,
                         {0.37, 0.0, 0.4},
                         Vector3d::UnitX(),
                         0.26,
                         {0.0, 0.065, 0.075},
                         {0.0, 1.0, 0.3}));
  links.push_back (limb (0,
                         {-0.4, 0.0, 0.1},
                         -Vector3d::UnitX(),
                         0.3,
                         {0.0, 0.03, 0.04},
                         {0.0, 1.0, 0.6}));
  return links;
}

} // namespace

std::vector<BodyLink>
bodyLinks (BodyKind body)
{
  switch (body) {
  case BodyKind::Hand:
    return handLinks();
  case BodyKind::Animal:
    return animalLinks();
  default:
    return chainLinks();
  }
}

} // namespace pcl_msf::synthetic
