// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Geometry>

#include <pcl_msf/rigid_pose.h>

#include <random>
#include <vector>

namespace pcl_msf::testing {

/** \brief An articulated body of boxes in a row along x, each turned against the one
 * before it about an axis through the seam. Metres. */
struct BoxChain {
  int boxes{3};
  double angle{0.2}; ///< radians, of every joint
  Eigen::Vector3d size{0.4, 0.22, 0.16};
  RigidPose root{{0.03, -0.05, 0.04, 0.02, -0.01, 0.015}}; ///< motion of the first box

  Eigen::Vector3d
  seam (int joint) const
  {
    return {joint * size.x(), 0.0, 0.0};
  }
  static Eigen::Vector3d
  axis (int joint)
  {
    return joint % 2 == 1 ? Eigen::Vector3d (0.1, 0.2, 1.0).normalized()
                          : Eigen::Vector3d (0.0, 1.0, -0.2).normalized();
  }
  /** \brief Motion of a box. */
  RigidPose
  pose (int box) const
  {
    RigidPose result = root;
    for (int j = 1; j <= box; ++j) {
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd (angle, axis (j)).toRotationMatrix();
      result = result * RigidPose::fromMatrix (turn, seam (j) - turn * seam (j));
    }
    return result;
  }
};

/** \brief Points drawn on the outside of a chain. */
struct ChainCloud {
  std::vector<Eigen::Vector3f> points; ///< moved when asked for
  std::vector<Eigen::Vector3f> rest;   ///< the same points before the motion
  std::vector<int> box;
};

inline bool
insideBox (const BoxChain& chain, int box, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d center ((box + 0.5) * chain.size.x(), 0.0, 0.0);
  return ((point - center).cwiseAbs() - 0.5 * chain.size).maxCoeff() < -1e-6;
}

/** \brief `count` points by area; where boxes overlap only the outside of all. */
inline ChainCloud
drawChain (
    const BoxChain& chain, int count, bool moved, unsigned seed, double noise = 0)
{
  std::mt19937 random (seed);
  const auto uniform = [&random] { return random() / 4294967296.0; };
  const auto normal = [&uniform] {
    double sum = 0.0;
    for (int k = 0; k < 12; ++k)
      sum += uniform();
    return sum - 6.0;
  };
  const Eigen::Vector3d& s = chain.size;
  const Eigen::Vector3d areas (s.y() * s.z(), s.x() * s.z(), s.x() * s.y());
  ChainCloud cloud;
  while (static_cast<int> (cloud.points.size()) < count) {
    const int box = static_cast<int> (uniform() * chain.boxes);
    double place = uniform() * areas.sum();
    int face = 0;
    while (face < 2 && place >= areas[face])
      place -= areas[face++];
    Eigen::Vector3d p (uniform() - 0.5, uniform() - 0.5, uniform() - 0.5);
    p[face] = random() % 2 ? 0.5 : -0.5;
    p = p.cwiseProduct (s) + Eigen::Vector3d ((box + 0.5) * s.x(), 0.0, 0.0);
    const bool cap =
        face == 0 && !((box == 0 && p.x() < 0.5 * s.x()) ||
                       (box == chain.boxes - 1 && p.x() > (box + 0.5) * s.x()));
    bool hidden = cap && !moved;
    const Eigen::Vector3d q = moved ? chain.pose (box) * p : p;
    for (int other = 0; other < chain.boxes && !hidden && moved; ++other)
      hidden =
          other != box && insideBox (chain, other, chain.pose (other).inverse() * q);
    if (hidden)
      continue;
    const Eigen::Vector3d jitter (normal(), normal(), normal());
    cloud.points.push_back ((q + noise * jitter).cast<float>());
    cloud.rest.push_back (p.cast<float>());
    cloud.box.push_back (box);
  }
  return cloud;
}

/** \brief A chain of two boxes that bends, and moves, so many times by 0.1 radians. */
inline BoxChain
bent (double times)
{
  BoxChain chain;
  chain.boxes = 2;
  chain.angle = 0.1 * times;
  for (double& p : chain.root.parameters)
    p *= times;
  return chain;
}

} // namespace pcl_msf::testing
