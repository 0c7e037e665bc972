// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rigid_pose.h>

#include <cmath>
#include <limits>

namespace pcl_msf {

/** \brief Two views of a static scene for tests of the PCL class: a tilted wall with a
 * ball in front, textured by a smooth function of the scene point, cast ray by ray. */
class RigidPair {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

  static constexpr int kWidth = 160;
  static constexpr int kHeight = 120;

  static PinholeCamera
  camera ()
  {
    return {150.0, 152.0, 79.5, 60.0};
  }

  /** \brief Reference points to the current frame. */
  static RigidPose
  motion ()
  {
    RigidPose pose;
    pose.parameters = {0.005, -0.01, 0.008, 0.02, -0.01, 0.015};
    return pose;
  }

  static Cloud::Ptr
  reference ()
  {
    return view ({});
  }
  static Cloud::Ptr
  current ()
  {
    return view (motion());
  }

  /** \brief The scene after any other motion. */
  static Cloud::Ptr
  view (const RigidPose& camera_from_scene)
  {
    const auto cloud = pcl::make_shared<Cloud> (kWidth, kHeight);
    const RigidPose scene_from_camera = camera_from_scene.inverse();
    const Eigen::Vector3d origin = scene_from_camera.translation();
    const Eigen::Matrix3d rotation = scene_from_camera.rotation();
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        const Eigen::Vector3d ray = camera().backProject (u, v, 1.0);
        const double z = depthAlong (origin, rotation * ray);
        auto& p = (*cloud) (u, v);
        p.getVector3fMap() = (z * ray).cast<float>();
        const Eigen::Vector3d scene_point = origin + z * (rotation * ray);
        p.r = p.g = p.b = brightness (scene_point);
        p.a = 255;
      }
    return cloud;
  }

private:
  /** Factor of the direction at which the ray meets the ball or the wall. */
  static double
  depthAlong (const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)
  {
    const Eigen::Vector3d wall_normal (0.2, -0.1, 1.0);
    const double wall = (2.5 - wall_normal.dot (origin)) / wall_normal.dot (direction);
    const Eigen::Vector3d to_ball = Eigen::Vector3d (0.1, 0.05, 1.8) - origin;
    const double a = direction.squaredNorm();
    const double b = direction.dot (to_ball);
    const double c = to_ball.squaredNorm() - 0.35 * 0.35;
    const double under_root = b * b - a * c;
    return under_root > 0.0 ? (b - std::sqrt (under_root)) / a : wall;
  }

  static unsigned char
  brightness (const Eigen::Vector3d& p)
  {
    const double waves = std::sin (23.0 * p.x() + 7.0 * p.z()) +
                         std::sin (19.0 * p.y() - 11.0 * p.x()) +
                         std::sin (41.0 * p.x() + 31.0 * p.y());
    return static_cast<unsigned char> (128.0 + 40.0 * waves);
  }
};

} // namespace pcl_msf
