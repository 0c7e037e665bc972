// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <synthetic/frame_view.h>
#include <synthetic/random.h>
#include <synthetic/scene_props.h>
#include <synthetic/shape.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;

/** A shape and a function that is negative inside of it. */
struct Case {
  const char* name;
  ShapePtr shape;
  std::function<double (const Eigen::Vector3d&)> inside;
};

std::vector<Case>
shapeCases ()
{
  const auto box = [] (const Eigen::Vector3d& p) {
    return std::max (
        {std::abs (p.x()) - 0.5, std::abs (p.y()) - 0.3, std::abs (p.z()) - 0.2});
  };
  const auto ellipsoid = [] (const Eigen::Vector3d& p) {
    return Eigen::Vector3d (p.x() / 0.5, p.y() / 0.3, p.z() / 0.4).norm() - 1.0;
  };
  const auto capsule = [] (const Eigen::Vector3d& p) {
    const double z = std::clamp (p.z(), 0.0, 0.6);
    return (p - Eigen::Vector3d (0, 0, z)).norm() - 0.2;
  };
  const auto cylinder = [] (const Eigen::Vector3d& p) {
    return std::max (p.head<2>().norm() - 0.25, std::abs (p.z()) - 0.4);
  };
  return {{"box", makeBox ({0.5, 0.3, 0.2}), box},
          {"ellipsoid", makeEllipsoid ({0.5, 0.3, 0.4}), ellipsoid},
          {"capsule", makeCapsule (0.6, 0.2), capsule},
          {"cylinder", makeCylinder (0.4, 0.25), cylinder}};
}

TEST (SyntheticShapes, RaysMeetTheNearestPointOfTheSurface)
{
  Random random (7);
  for (const Case& c : shapeCases()) {
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
      const Eigen::Vector3d origin = 2.0 * random.direction();
      const Eigen::Vector3d target = 0.4 * random.direction();
      const Ray ray{origin, 0.7 * (target - origin)};
      ShapeHit hit;
      const bool found = c.shape->intersect (ray, 1e9, hit);
      // March until the ray is inside.
      double s = 0.0;
      while (s < 4.0 && c.inside (ray.at (s)) > 0.0)
        s += 1e-3;
      if (!found) {
        EXPECT_GE (s, 4.0) << c.name;
        continue;
      }
      ++hits;
      EXPECT_NEAR (c.inside (ray.at (hit.s)), 0.0, 1e-12) << c.name;
      EXPECT_LT (hit.s, s + 1e-9) << c.name;
      EXPECT_NEAR (hit.normal.norm(), 1.0, 1e-12) << c.name;
      EXPECT_LT (hit.normal.dot (ray.direction), 1e-12) << c.name;
      // Outwards along the normal is outside.
      EXPECT_GT (c.inside (ray.at (hit.s) + 1e-6 * hit.normal), 0.0) << c.name;
      EXPECT_LE (ray.at (hit.s).norm(), c.shape->radius() + 1e-12) << c.name;
      EXPECT_FALSE (c.shape->intersect (ray, hit.s, hit)) << c.name;
    }
    EXPECT_GT (hits, 100) << c.name;
  }
}

TEST (SyntheticShapes, SphereBoundsHoldTheSpheresImage)
{
  const PinholeCamera camera{260.0, 260.0, 159.5, 119.5};
  Random random (3);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d center (
        random.uniform (-2, 2), random.uniform (-2, 2), random.uniform (0.2, 4));
    const double radius = random.uniform (0.1, 0.6);
    const cv::Rect2d box = sphereBounds (center, radius, camera);
    for (int j = 0; j < 50; ++j) {
      const Eigen::Vector3d p = center + radius * random.direction();
      if (p.z() < 1e-3)
        continue;
      const Eigen::Vector2d uv = camera.project (p);
      EXPECT_GE (uv.x(), box.x);
      EXPECT_GE (uv.y(), box.y);
      EXPECT_LE (uv.x(), box.x + box.width);
      EXPECT_LE (uv.y(), box.y + box.height);
    }
  }
  EXPECT_TRUE (sphereBounds ({0, 0, -3}, 0.5, camera).empty());
}

/** Only the soft surface of a scene, as the camera sees it at some phase. */
std::unique_ptr<PartView>
softViewOf (const SceneModel& scene, const PinholeCamera& camera, double phase)
{
  for (const Part& part : scene.parts)
    if (part.soft)
      return makePartView (part,
                           scene.bodies[part.body].world_from_body,
                           scene.world_from_camera (phase).inverse(),
                           camera,
                           phase);
  return nullptr;
}

TEST (SyntheticShapes, SoftSurfacesAreHitExactly)
{
  const PinholeCamera camera{260.0, 260.0, 159.5, 119.5};
  for (const SceneKind name : {SceneKind::Bending, SceneKind::Breathing})
    for (const double phase : {0.0, 9.0, 21.0}) {
      const SceneModel scene = buildScene (name, 2);
      const auto view = softViewOf (scene, camera, phase);
      ASSERT_TRUE (view);
      int hits = 0;
      for (int v = 0; v < 240; v += 3)
        for (int u = 0; u < 320; u += 3) {
          const Eigen::Vector3d direction = camera.backProject (u, v, 1.0);
          ViewHit hit;
          if (!view->cast (direction, 1e9, hit))
            continue;
          ++hits;
          const Eigen::Vector3d point = hit.depth * direction;
          EXPECT_LT ((view->place (hit.material) - point).norm(), 1e-9);
          EXPECT_LT (hit.normal.dot (direction), 1e-9);
          // Nothing of the surface is nearer.
          EXPECT_FALSE (view->cast (direction, hit.depth - 1e-7, hit));
        }
      EXPECT_GT (hits, 700);
    }
}

TEST (SyntheticShapes, SoftSurfacesHaveNoHolesInside)
{
  // Places on the surface, cast from the camera, are hit or hidden by something nearer.
  const PinholeCamera camera{260.0, 260.0, 159.5, 119.5};
  Random random (11);
  for (const SceneKind name : {SceneKind::Bending, SceneKind::Breathing}) {
    const SceneModel scene = buildScene (name, 4);
    const auto view = softViewOf (scene, camera, 14.0);
    int missed = 0;
    for (int i = 0; i < 4000; ++i) {
      const Eigen::Vector3d material (
          random.uniform (-0.55, 0.55), random.uniform (-0.4, 0.4), 0.0);
      const Eigen::Vector3d point = view->place (material);
      ViewHit hit;
      const bool found = view->cast (point / point.z(), 1e9, hit);
      missed += !found || hit.depth > point.z() + 1e-8;
    }
    // At a silhouette the two hits of a ray run together.
    EXPECT_LE (missed, 8);
  }
}

} // namespace
