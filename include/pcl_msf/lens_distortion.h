// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/export.h>
#include <pcl_msf/pinhole_camera.h>

#include <string>

namespace pcl_msf {

/** \brief How a lens departs from a pinhole: the model of Brown (1966) with OpenCV's
 * order and signs, on image places (x, y) = (u - cx, v - cy) / f of a pinhole camera:
 *
 * x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2), likewise y' with
 * p1 and p2 changed over. All 0 (default) = no distortion.
 */
struct PCL_MSF_EXPORT LensDistortion {
  double k1{0.0}; ///< radial, second order
  double k2{0.0}; ///< radial, fourth order
  double p1{0.0}; ///< tangential
  double p2{0.0}; ///< tangential
  double k3{0.0}; ///< radial, sixth order

  bool
  isNone () const
  {
    return k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0 && k3 == 0.0;
  }

  /** \brief Can images of this camera and size (pixels) be freed from it?
   * \param[out] why when not null and the answer is no: what is wrong and the remedy
   * \details Finite values; no part of the image is folded over another. */
  bool
  isValid (const PinholeCamera& camera,
           int width,
           int height,
           std::string* why = nullptr) const;

  /** \brief Where the lens shows what a pinhole shows at (x, y). */
  Eigen::Vector2d
  distorted (const Eigen::Vector2d& place) const;

  /** \brief The inverse, to 1e-12; NaN where there is none. */
  Eigen::Vector2d
  undistorted (const Eigen::Vector2d& place) const;

  /** \brief The same for pixels of a camera. */
  Eigen::Vector2d
  distortedPixel (const PinholeCamera& camera, double u, double v) const;

  /** \brief The inverse of distortedPixel; NaN where there is none. */
  Eigen::Vector2d
  undistortedPixel (const PinholeCamera& camera, double u, double v) const;
};

inline bool
operator== (const LensDistortion& a, const LensDistortion& b)
{
  return a.k1 == b.k1 && a.k2 == b.k2 && a.p1 == b.p1 && a.p2 == b.p2 && a.k3 == b.k3;
}

inline bool
operator!= (const LensDistortion& a, const LensDistortion& b)
{
  return !(a == b);
}

} // namespace pcl_msf
