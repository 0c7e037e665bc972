// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Geometry>

#include <cmath>
#include <random>
#include <vector>

namespace pcl_msf::testing {

/** \brief Points with brightness before and after a motion within their own surface,
 * which shape does not tell. */
struct SlidClouds {
  std::vector<Eigen::Vector3f> source;
  std::vector<Eigen::Vector3f> target;
  std::vector<Eigen::Vector3f> truth; ///< per source point
  std::vector<float> source_brightness;
  std::vector<float> target_brightness;

  double
  meanError (const std::vector<Eigen::Vector3f>& warped) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
      sum += (warped[i] - truth[i]).norm();
    return sum / static_cast<double> (truth.size());
  }
};

/** \brief A smooth pattern, about 0.1 to 0.9. \param p metres */
inline double
patternAt (const Eigen::Vector3d& p)
{
  return 0.5 + 0.15 * std::sin (17.0 * p.x() + 9.0 * p.y()) +
         0.15 * std::sin (23.0 * p.y() - 11.0 * p.z() + 1.0) +
         0.1 * std::sin (29.0 * p.z() + 7.0 * p.x() + 2.0);
}

/** \brief A closed cylinder about x, a metre long and 0.3 thick.
 * \param turn of the half with x >= from about x, radians */
inline SlidClouds
turnedCylinder (double turn, double from = -1.0, int count = 2000)
{
  std::mt19937 random (5);
  const auto uniform = [&random] { return random() / 4294967296.0; };
  constexpr double r = 0.15;
  const auto draw = [&uniform] {
    const double place = uniform() * (1.0 + r); // side, caps
    const double angle = 2.0 * M_PI * uniform();
    const double out = place < 1.0 ? r : r * std::sqrt (uniform());
    const double x = place < 1.0 ? place : (place < 1.0 + 0.5 * r ? 0.0 : 1.0);
    return Eigen::Vector3d (x, out * std::cos (angle), out * std::sin (angle));
  };
  const auto move = [&] (const Eigen::Vector3d& p) {
    const double angle = p.x() >= from ? turn : 0.0;
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd (angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
    return Eigen::Vector3d (rotation * p + Eigen::Vector3d (0.01, 0.02, 0.0));
  };
  SlidClouds clouds;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = draw();
    clouds.source.push_back (p.cast<float>());
    clouds.source_brightness.push_back (static_cast<float> (patternAt (p)));
    clouds.truth.push_back (move (p).cast<float>());
    const Eigen::Vector3d q = draw();
    clouds.target.push_back (move (q).cast<float>());
    clouds.target_brightness.push_back (static_cast<float> (patternAt (q)));
  }
  return clouds;
}

/** \brief A flat wall, a metre square, of which both clouds see the same window.
 * \param slide of the wall behind it along x, metres */
inline SlidClouds
slidWall (double slide)
{
  std::mt19937 random (6);
  const auto uniform = [&random] { return random() / 4294967296.0; };
  const Eigen::Vector3d shift (slide, 0.5 * slide, 0.01);
  SlidClouds clouds;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d p (uniform(), uniform(), 0.0);
    clouds.source.push_back (p.cast<float>());
    clouds.source_brightness.push_back (static_cast<float> (patternAt (p)));
    clouds.truth.push_back ((p + shift).cast<float>());
    const Eigen::Vector3d q (uniform(), uniform(), shift.z());
    clouds.target.push_back (q.cast<float>());
    clouds.target_brightness.push_back (static_cast<float> (patternAt (q - shift)));
  }
  return clouds;
}

} // namespace pcl_msf::testing
