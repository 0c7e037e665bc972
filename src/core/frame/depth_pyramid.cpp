// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/depth_pyramid.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** Every second pixel of a row, of which all have neighbours on all sides. */
struct CoarseRow {
  const float* above; ///< at the first one, in the row above
  const float* own;
  const float* below;
  int n;
  float noise; ///< tolerance by it
  float same_surface;
  float* coarse;
};

/** Takes part in a mean if it is measured and near the lead. */
[[gnu::always_inline]] inline void
addPixel (
    float value, float lead, float tolerance, float times, float& sum, float& weight)
{
  const bool same = value > 0.0f && std::abs (value - lead) < tolerance;
  sum += same ? times * value : 0.0f;
  weight += same ? times : 0.0f;
}

[[gnu::always_inline]] inline float
larger (float a, float b)
{
  return a < b ? b : a;
}

[[gnu::always_inline]] inline void
averageRow (const CoarseRow& row)
{
  const float* a = row.above;
  const float* b = row.own;
  const float* c = row.below;
#pragma omp simd
  for (int i = 0; i < row.n; ++i) {
    const int x = 2 * i;
    const float sides = larger (larger (a[x], c[x]), larger (b[x - 1], b[x + 1]));
    const float corners =
        larger (larger (a[x - 1], a[x + 1]), larger (c[x - 1], c[x + 1]));
    const float lead = b[x] > 0.0f ? b[x] : larger (sides, corners);
    const float tolerance = larger (row.noise, row.same_surface * lead);
    float sum = 0.0f;
    float weight = 0.0f;
    addPixel (a[x - 1], lead, tolerance, 1.0f, sum, weight);
    addPixel (a[x], lead, tolerance, 2.0f, sum, weight);
    addPixel (a[x + 1], lead, tolerance, 1.0f, sum, weight);
    addPixel (b[x - 1], lead, tolerance, 2.0f, sum, weight);
    addPixel (b[x], lead, tolerance, 4.0f, sum, weight);
    addPixel (b[x + 1], lead, tolerance, 2.0f, sum, weight);
    addPixel (c[x - 1], lead, tolerance, 1.0f, sum, weight);
    addPixel (c[x], lead, tolerance, 2.0f, sum, weight);
    addPixel (c[x + 1], lead, tolerance, 1.0f, sum, weight);
    const float mean = sum / larger (weight, 1.0f);
    row.coarse[i] = lead > 0.0f ? mean : 0.0f;
  }
}

PCL_MSF_VERSIONS (averageSurfaces, averageRow, CoarseRow)

} // namespace

cv::Mat
inverseDepth (const cv::Mat& depth, double min_depth, double max_depth)
{
  cv::Mat result (depth.size(), CV_32FC1);
  const auto low = static_cast<float> (std::max (min_depth, 1e-6));
  const auto high = static_cast<float> (max_depth);
  for (int y = 0; y < depth.rows; ++y) {
    const float* z = depth.ptr<float> (y);
    float* w = result.ptr<float> (y);
    for (int x = 0; x < depth.cols; ++x)
      w[x] = z[x] >= low && z[x] <= high ? 1.0f / z[x] : 0.0f;
  }
  return result;
}

cv::Mat
halveInverseDepth (const cv::Mat& w,
                   double noise,
                   const FrameTuning& tuning,
                   InstructionSet set)
{
  cv::Mat with_border;
  cv::copyMakeBorder (w, with_border, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0.0);
  cv::Mat result ((w.rows + 1) / 2, (w.cols + 1) / 2, CV_32FC1);
  for (int y = 0; y < result.rows; ++y)
    averageSurfaces ({with_border.ptr<float> (2 * y) + 1,
                      with_border.ptr<float> (2 * y + 1) + 1,
                      with_border.ptr<float> (2 * y + 2) + 1,
                      result.cols,
                      tuning.same_sigmas * static_cast<float> (noise),
                      tuning.same_surface,
                      result.ptr<float> (y)},
                     set);
  return result;
}

} // namespace pcl_msf
