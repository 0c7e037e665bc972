// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/point_size.h"

#include "core/base/order_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf::visualization {

namespace {

constexpr double kOverlap = 1.25; ///< hides most gaps

/** Distance between neighbouring points of an organized set in the picture, pixels:
 * the 75th percentile. 1 when nobody can tell. */
double
pointSpacing (const PointSet& set, const View& view)
{
  std::vector<double> spacing;
  const cv::Mat& p = set.positions;
  const int step = std::max (1, p.rows / 64);
  for (int row = 0; row + 1 < p.rows; row += step)
    for (int col = 0; col + 1 < p.cols; col += step) {
      const auto& a = p.at<cv::Vec3f> (row, col);
      const auto& b = p.at<cv::Vec3f> (row, col + 1);
      const double d =
          (view.project ({a[0], a[1], a[2]}) - view.project ({b[0], b[1], b[2]}))
              .norm();
      if (std::isfinite (d))
        spacing.push_back (d);
    }
  if (spacing.empty())
    return 1.0;
  return nthSmallest (spacing, 3 * (spacing.size() - 1) / 4);
}

} // namespace

double
pointSize (const PointSet& set, const View& view, const PictureStyle& style)
{
  if (style.point_size > 0.0)
    return style.point_size;
  const double largest = std::max (3.0, style.size.height / 120.0);
  return std::clamp (kOverlap * pointSpacing (set, view), 1.0, largest);
}

} // namespace pcl_msf::visualization
