// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_matching.h"
#include <pcl_msf/rigid_pose.h>

#include <algorithm>

namespace pcl_msf {

/** \brief What pulls at many points that move rigidly: their summed energy as a
 * quadratic of the twelve numbers of rotation matrix and translation. It is exact for
 * every pose, however far, and sums add up. */
class RigidMoments {
public:
  RigidMoments()
  {
    std::fill_n (h_.data(), h_.size(), 0.0); // Eigen's own would be shared, aligned
    std::fill_n (v_.data(), v_.size(), 0.0);
  }

  void
  add (const Eigen::Vector3d& point, const PointPull& pull, double weight);
  void
  add (const RigidMoments& other);

  double
  cost (const RigidPose& pose) const;

  /** \brief The best pose near a start. \param[out] information of the pose's
   * parameters; may be null */
  RigidPose
  solve (const RigidPose& start, Matrix6* information = nullptr) const;

  /** \brief How firmly the pulls hold the points in each direction, target frame. */
  Eigen::Matrix3d
  hold () const
  {
    return h_.bottomRightCorner<3, 3>();
  }

  /** \brief Weight of the points. */
  double
  weight () const
  {
    return weight_;
  }

private:
  using Numbers = Eigen::Matrix<double, 12, 1, Eigen::DontAlign>;

  double
  valueAt (const Numbers& z) const;
  Matrix6
  quadratic (const Numbers& z) const;

  Eigen::Matrix<double, 12, 12, Eigen::DontAlign> h_;
  Numbers v_;
  double c_{0.0};
  double weight_{0.0};
};

} // namespace pcl_msf
