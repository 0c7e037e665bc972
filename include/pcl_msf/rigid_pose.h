// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/export.h>

#include <array>

namespace pcl_msf {

/** \brief 6x6 matrix without alignment requirements: safe as a member of public classes
 * whatever vector instructions the including code is compiled for. */
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;

/** \brief 6-vector without alignment requirements. */
using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

// What lies in public structures or passes between the library and code compiled with
// other vector instructions: 4x4 matrices of floats would not do.
static_assert (alignof (Matrix6) == alignof (double) &&
               alignof (Vector6) == alignof (double) &&
               alignof (Eigen::Matrix3d) == alignof (double) &&
               alignof (Eigen::Vector3d) == alignof (double) &&
               alignof (Eigen::Vector3f) == alignof (float));

/** \brief A rigid motion `b_from_a` as (angle-axis, translation): the paper's T_k.
 *
 * Six doubles: rotation vector in radians (axis times angle), translation in metres. It
 * takes a point of frame a to frame b: p_b = R (rotation) p_a + translation.
 */
struct PCL_MSF_EXPORT RigidPose {
  std::array<double, 6> parameters{}; ///< ax ay az [rad], tx ty tz [m]; zero = identity

  static RigidPose
  fromMatrix (const Eigen::Matrix<double, 3, 3>& rotation,
              const Eigen::Vector3d& translation);

  /** \brief From the upper 3x4 of a homogeneous matrix; the rotation part is projected
   * to the nearest rotation. */
  static EIGEN_ALWAYS_INLINE RigidPose // never compiled once for callers that differ
  fromMatrix (const Eigen::Matrix<float, 4, 4>& b_from_a)
  {
    return fromNearestRotation (b_from_a.topLeftCorner<3, 3>().cast<double>(),
                                b_from_a.topRightCorner<3, 1>().cast<double>());
  }

  /** \brief Eq. 4, safe at zero angle. */
  Eigen::Matrix<double, 3, 3>
  rotation () const;

  Eigen::Vector3d
  translation () const
  {
    return {parameters[3], parameters[4], parameters[5]};
  }

  Eigen::Vector3d
  operator* (const Eigen::Vector3d& point) const;

  /** \brief `c_from_b * b_from_a` = `c_from_a`. */
  RigidPose
  operator* (const RigidPose& b_from_a) const;

  RigidPose
  inverse () const;

  EIGEN_ALWAYS_INLINE Eigen::Matrix<float, 4, 4>
  matrix () const
  {
    Eigen::Matrix<float, 4, 4> m = Eigen::Matrix<float, 4, 4>::Identity();
    m.topLeftCorner<3, 3>() = rotation().cast<float>();
    m.topRightCorner<3, 1>() = translation().cast<float>();
    return m;
  }

  /** \brief Rotation angle, radians in [0, pi]. */
  double
  angle () const;

  bool
  isFinite () const;

private:
  static RigidPose
  fromNearestRotation (const Eigen::Matrix<double, 3, 3>& matrix,
                       const Eigen::Vector3d& translation);
};
static_assert (sizeof (RigidPose) == 6 * sizeof (double));

/** \brief Rotation matrix of a rotation vector (Eq. 4), safe at zero. */
PCL_MSF_EXPORT Eigen::Matrix<double, 3, 3>
rotationFromVector (const Eigen::Vector3d& rotation_vector);

/** \brief Rotation vector (angle in [0, pi]) of a rotation matrix, safe at 0 and pi. */
PCL_MSF_EXPORT Eigen::Vector3d
vectorFromRotation (const Eigen::Matrix<double, 3, 3>& rotation);

/** \brief Left Jacobian of SO(3): d (R (a) p) / d a = -[R (a) p]_x J_l (a). */
PCL_MSF_EXPORT Eigen::Matrix<double, 3, 3>
leftJacobian (const Eigen::Vector3d& rotation_vector);

/** \brief Cross-product matrix. */
PCL_MSF_EXPORT Eigen::Matrix<double, 3, 3>
skew (const Eigen::Vector3d& v);

} // namespace pcl_msf
