// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <array>
#include <map>
#include <vector>

namespace pcl_msf::visualization {

/** \brief The shape that points sample, as far as light and point size need it: cubes
 * and the plane in each. */
class CloudLight {
public:
  /** \param points one or more that are finite */
  explicit CloudLight (const std::vector<Eigen::Vector3f>& points);

  /** \brief [0, 1]: how bright the surface at a point is, whichever side is out. */
  double
  at (const Eigen::Vector3f& point) const;

  /** \brief Distance between neighbouring points. */
  double
  spacing () const
  {
    return spacing_;
  }

private:
  using Key = std::array<int, 3>;

  /** Points of a cube, in sides. */
  struct Cube {
    double count{0.0};
    Eigen::Vector3d sum{Eigen::Vector3d::Zero()};
    Eigen::Matrix3d squares{Eigen::Matrix3d::Zero()};

    void
    add (const Cube& other);
  };

  static float
  lightOf (const Cube& cube);
  std::map<Key, Cube>
  fill (const std::vector<Eigen::Vector3f>& points) const;
  Key
  keyOf (const Eigen::Vector3f& point) const;

  Eigen::Vector3f low_;
  float side_{1.0F};
  std::map<Key, float> light_;
  double spacing_{0.0};
};

} // namespace pcl_msf::visualization
