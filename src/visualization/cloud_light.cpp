// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/cloud_light.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl_msf::visualization {

namespace {

constexpr std::size_t kFewest = 6; // points of a cube, mean
constexpr float kCubes = 70.0F;    // along the diagonal
constexpr double kAmbient = 0.35;  // light on a surface seen from its edge

} // namespace

CloudLight::CloudLight (const std::vector<Eigen::Vector3f>& points)
{
  Eigen::Vector3f high = Eigen::Vector3f::Constant (-INFINITY);
  low_.setConstant (INFINITY);
  for (const auto& p : points)
    if (p.allFinite()) {
      low_ = low_.cwiseMin (p);
      high = high.cwiseMax (p);
    }
  side_ = std::max ((high - low_).norm() / kCubes, 1e-20F);
  const float largest = 0.25F * kCubes * side_;
  std::map<Key, Cube> cubes = fill (points);
  while (kFewest * cubes.size() > points.size() && side_ < largest) {
    side_ *= 1.5F;
    cubes = fill (points);
  }
  double count = 0.0;
  for (const auto& [key, cube] : cubes)
    count += cube.count;
  for (const auto& [key, own] : cubes) {
    Cube all;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (const auto near = cubes.find ({key[0] + x, key[1] + y, key[2] + z});
              near != cubes.end())
            all.add (near->second);
    light_[key] = lightOf (all);
  }
  spacing_ = side_ * std::sqrt (cubes.size() / std::max (1.0, count));
}

/** From the upper left in front, as the eye of an orbit sees it. */
float
CloudLight::lightOf (const Cube& cube)
{
  const Eigen::Vector3d mean = cube.sum / cube.count;
  const Eigen::Matrix3d spread = cube.squares / cube.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect (spread);
  const Eigen::Vector3d lamp = Eigen::Vector3d (-0.5, -0.6, -0.8).normalized();
  const double facing = std::abs (eigen.eigenvectors().col (0).dot (lamp));
  return static_cast<float> (kAmbient + (1.0 - kAmbient) * facing);
}

void
CloudLight::Cube::add (const Cube& other)
{
  count += other.count;
  sum += other.sum;
  squares += other.squares;
}

std::map<CloudLight::Key, CloudLight::Cube>
CloudLight::fill (const std::vector<Eigen::Vector3f>& points) const
{
  std::map<Key, Cube> cubes;
  for (const auto& p : points)
    if (p.allFinite()) {
      Cube& cube = cubes[keyOf (p)];
      const Eigen::Vector3d q = ((p - low_) / side_).cast<double>();
      cube.count += 1.0;
      cube.sum += q;
      cube.squares += q * q.transpose();
    }
  return cubes;
}

CloudLight::Key
CloudLight::keyOf (const Eigen::Vector3f& point) const
{
  Key key{};
  for (int c = 0; c < 3; ++c)
    key[c] = static_cast<int> ((point[c] - low_[c]) / side_);
  return key;
}

double
CloudLight::at (const Eigen::Vector3f& point) const
{
  const auto found = light_.find (keyOf (point));
  return found == light_.end() ? 1.0 : found->second;
}

} // namespace pcl_msf::visualization
