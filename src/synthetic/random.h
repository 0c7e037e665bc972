// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <synthetic/lattice_noise.h>

namespace pcl_msf::synthetic {

/** \brief Random numbers that are the same on every platform. */
class Random {
public:
  explicit Random (std::uint64_t seed) : state_ (mixed (seed)) {}

  double
  uniform (double low, double high)
  {
    return low + (high - low) * uniformFrom (state_++);
  }

  int
  below (int count)
  {
    return static_cast<int> (uniform (0.0, count));
  }

  /** \brief -1 or 1. */
  double
  sign ()
  {
    return uniform (0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  }

  /** \brief Uniform on the unit sphere. */
  Eigen::Vector3d
  direction ()
  {
    const double z = uniform (-1.0, 1.0), angle = uniform (0.0, 2.0 * M_PI);
    const double r = std::sqrt (1.0 - z * z);
    return {r * std::cos (angle), r * std::sin (angle), z};
  }

private:
  std::uint64_t state_;
};

} // namespace pcl_msf::synthetic
