// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/export.h>

#include <string>

namespace pcl_msf {

/** \brief Pinhole camera without distortion (Eq. 2 and 3 of the paper).
 *
 * Camera frame: x right, y down, z forward, metres. Image frame: pixels, centres at
 * integer coordinates, so the image of width w covers [-0.5, w - 0.5].
 */
struct PCL_MSF_EXPORT PinholeCamera {
  double fx{0.0}; ///< focal length in x, pixels, > 0
  double fy{0.0}; ///< focal length in y, pixels, > 0
  double cx{0.0}; ///< principal point x, pixels
  double cy{0.0}; ///< principal point y, pixels

  /** \brief Is this a camera for images of the given size (pixels)?
   * \param[out] why when not null and the answer is no: what is wrong and the remedy
   * \details Finite values, focal lengths between 1 % and 100 times the larger image
   * side, principal point no further than one image size outside the image. */
  bool
  isValid (int width, int height, std::string* why = nullptr) const;

  /** \brief Pixel of a point, Eq. 2. \param point metres, z must not be 0 */
  Eigen::Vector2d
  project (const Eigen::Vector3d& point) const
  {
    return {fx * point.x() / point.z() + cx, fy * point.y() / point.z() + cy};
  }

  /** \brief Point seen at pixel (u, v) at depth z metres, Eq. 3. */
  Eigen::Vector3d
  backProject (double u, double v, double z) const
  {
    return {z * (u - cx) / fx, z * (v - cy) / fy, z};
  }

  /** \brief The camera of the next coarser pyramid level, whose pixel (i, j) lies on
   * pixel (2 i, 2 j) of this one. */
  PinholeCamera
  halved () const
  {
    return {0.5 * fx, 0.5 * fy, 0.5 * cx, 0.5 * cy};
  }
};

} // namespace pcl_msf
