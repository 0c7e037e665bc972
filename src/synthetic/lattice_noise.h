// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief A well mixed number for a place in a random sequence (SplitMix64's finish).
 */
inline std::uint64_t
mixed (std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/** \brief Uniform in [0, 1). */
inline double
uniformFrom (std::uint64_t key)
{
  return static_cast<double> (mixed (key) >> 11) * 0x1.0p-53;
}

/** \brief Standard normal number of a key (Box and Muller). */
double
normalFrom (std::uint64_t key);

/** \brief Smooth scalar noise in space with features of about one cell, in [-1, 1],
 * rms about 0.35. Thread-safe once made. */
class LatticeNoise {
public:
  explicit LatticeNoise (std::uint64_t seed);

  /** \param p in cells */
  float
  operator() (const Eigen::Vector3f& p) const;

private:
  static constexpr int size_ = 32;
  std::vector<float> values_;
};

} // namespace pcl_msf::synthetic
