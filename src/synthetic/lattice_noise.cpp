// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/lattice_noise.h>

#include <algorithm>

namespace pcl_msf::synthetic {

double
normalFrom (std::uint64_t key)
{
  const double u = std::max (uniformFrom (2 * key), 1e-300);
  const double angle = 2.0 * M_PI * uniformFrom (2 * key + 1);
  return std::sqrt (-2.0 * std::log (u)) * std::cos (angle);
}

LatticeNoise::LatticeNoise (std::uint64_t seed) : values_ (size_ * size_ * size_)
{
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] = static_cast<float> (2.0 * uniformFrom (mixed (seed) + 7919 * i) - 1.0);
}

float
LatticeNoise::operator() (const Eigen::Vector3f& p) const
{
  constexpr int mask = size_ - 1;
  int low[3], high[3];
  float weight[3];
  for (int a = 0; a < 3; ++a) {
    // A floor that needs no call; cells are far below the range of int.
    int cell = static_cast<int> (p[a]);
    cell -= static_cast<float> (cell) > p[a] ? 1 : 0;
    const float f = p[a] - static_cast<float> (cell);
    weight[a] = f * f * (3.0f - 2.0f * f);
    low[a] = cell & mask;
    high[a] = (cell + 1) & mask;
  }
  const float* v = values_.data();
  const auto along_x = [&] (int y, int z) {
    const float* row = v + size_ * (y + size_ * z);
    return row[low[0]] + weight[0] * (row[high[0]] - row[low[0]]);
  };
  const float a = along_x (low[1], low[2]), b = along_x (high[1], low[2]);
  const float c = along_x (low[1], high[2]), d = along_x (high[1], high[2]);
  const float front = a + weight[1] * (b - a);
  const float back = c + weight[1] * (d - c);
  return front + weight[2] * (back - front);
}

} // namespace pcl_msf::synthetic
