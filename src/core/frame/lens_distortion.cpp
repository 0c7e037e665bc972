// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/LU>

#include "core/base/number_text.h"
#include <pcl_msf/lens_distortion.h>

#include <cmath>
#include <limits>

namespace pcl_msf {
namespace {

constexpr double accuracy = 1e-12; ///< of the inverse
constexpr int most_steps = 50;

Eigen::Vector2d
placeOf (const PinholeCamera& camera, double u, double v)
{
  return {(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy};
}

Eigen::Vector2d
pixelOf (const PinholeCamera& camera, const Eigen::Vector2d& place)
{
  return {camera.fx * place.x() + camera.cx, camera.fy * place.y() + camera.cy};
}

/** Derivative of LensDistortion::distorted. */
Eigen::Matrix2d
derivative (const LensDistortion& lens, const Eigen::Vector2d& place)
{
  const double x = place.x(), y = place.y(), r2 = place.squaredNorm();
  const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope = 2.0 * (lens.k1 + r2 * (2.0 * lens.k2 + 3.0 * r2 * lens.k3));
  const double mixed = slope * x * y + 2.0 * (lens.p1 * x + lens.p2 * y);
  Eigen::Matrix2d d;
  d << radial + slope * x * x + 2.0 * lens.p1 * y + 6.0 * lens.p2 * x, mixed, mixed,
      radial + slope * y * y + 6.0 * lens.p1 * y + 2.0 * lens.p2 * x;
  return d;
}

/** Neither folded nor turned inside out. */
bool
isUpright (const LensDistortion& lens, const Eigen::Vector2d& place)
{
  const Eigen::Matrix2d d = derivative (lens, place);
  return d.determinant() > 0.0 && d.trace() > 0.0;
}

} // namespace

bool
LensDistortion::isValid (const PinholeCamera& camera,
                         int width,
                         int height,
                         std::string* why) const
{
  constexpr int steps = 16;
  bool ok = std::isfinite (k1 + k2 + p1 + p2 + k3);
  for (int i = 0; i <= steps && ok; ++i)
    for (int j = 0; j <= steps && ok; ++j) {
      const double u = i * (width - 1.0) / steps, v = j * (height - 1.0) / steps;
      ok = isUpright (*this, placeOf (camera, u, v)) &&
           undistortedPixel (camera, u, v).allFinite();
    }
  if (!ok && why)
    *why = "no lens distortion for " + std::to_string (width) + "x" +
           std::to_string (height) + " images: k1 " + generalText (k1) + ", k2 " +
           generalText (k2) + ", p1 " + generalText (p1) + ", p2 " + generalText (p2) +
           ", k3 " + generalText (k3) +
           " fold the image; give the calibration's numbers in this order";
  return ok;
}

Eigen::Vector2d
LensDistortion::distorted (const Eigen::Vector2d& place) const
{
  const double x = place.x(), y = place.y(), r2 = place.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

Eigen::Vector2d
LensDistortion::undistorted (const Eigen::Vector2d& place) const
{
  // Newton's method from the place itself, halving steps that lead away.
  Eigen::Vector2d at = place;
  double error = (distorted (at) - place).norm();
  for (int i = 0; i < most_steps && error > accuracy; ++i) {
    const Eigen::Vector2d step =
        derivative (*this, at).inverse() * (place - distorted (at));
    double share = 1.0;
    while (share > 1e-3 && !((distorted (at + share * step) - place).norm() < error))
      share *= 0.5;
    at += share * step;
    error = (distorted (at) - place).norm();
  }
  if (error <= 1e3 * accuracy && isUpright (*this, at))
    return at;
  return Eigen::Vector2d::Constant (std::numeric_limits<double>::quiet_NaN());
}

Eigen::Vector2d
LensDistortion::distortedPixel (const PinholeCamera& camera, double u, double v) const
{
  return pixelOf (camera, distorted (placeOf (camera, u, v)));
}

Eigen::Vector2d
LensDistortion::undistortedPixel (const PinholeCamera& camera, double u, double v) const
{
  return pixelOf (camera, undistorted (placeOf (camera, u, v)));
}

} // namespace pcl_msf
