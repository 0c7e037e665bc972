// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace pcl_msf::io {

/** \brief Is a matrix that was read a rotation, up to the digits of a text? */
inline bool
isRotation (const Eigen::Matrix3d& matrix)
{
  const double skewness =
      (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).norm();
  return skewness < 1e-3 && matrix.determinant() > 0.0;
}

} // namespace pcl_msf::io
