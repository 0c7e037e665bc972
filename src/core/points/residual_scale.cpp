// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/residual_scale.h"

#include "core/base/order_statistics.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

double
deviationOf (const MovedPoints& moved,
             const std::vector<PointPull>& pulls,
             double least)
{
  std::vector<double> residuals;
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    if (!(pulls[i].weight > least))
      continue;
    const Eigen::Vector3d x = moved.points[i].cast<double>();
    const double cost =
        x.dot (pulls[i].a * x) - 2.0 * pulls[i].b.dot (x) + 2.0 * pulls[i].c;
    residuals.push_back (std::max (0.0, cost / pulls[i].weight));
  }
  if (residuals.empty())
    return 0.0;
  return kMadToSigma * std::sqrt (median (residuals));
}

} // namespace pcl_msf
