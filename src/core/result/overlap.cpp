// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/overlap.h"

#include "core/base/bilinear.h"
#include "core/base/order_statistics.h"
#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_msf {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

bool
isKnown (const cv::Vec2f& way)
{
  return std::isfinite (way[0]) && std::isfinite (way[1]);
}

/** Between pixels; NaN outside. */
float
sampleAt (const cv::Mat& image, float x, float y)
{
  if (!(x >= 0.0f && y >= 0.0f && x <= static_cast<float> (image.cols - 1) &&
        y <= static_cast<float> (image.rows - 1)))
    return kNone;
  const int x0 = std::min (static_cast<int> (x), image.cols - 2);
  const int y0 = std::min (static_cast<int> (y), image.rows - 2);
  const float a = x - static_cast<float> (x0);
  const float b = y - static_cast<float> (y0);
  const float* const top = image.ptr<float> (y0) + x0;
  const float* const low = image.ptr<float> (y0 + 1) + x0;
  return bilinear (a, b, top[0], top[1], low[0], low[1]);
}

/** A visible point's intensity in the other frame; NaN for all others. */
float
found (const cv::Mat& intensity, const SceneFlow& flow, int u, int v)
{
  const cv::Vec2f& way = flow.flow.at<cv::Vec2f> (v, u);
  if (flow.visibility.at<unsigned char> (v, u) != Visibility::Visible || !isKnown (way))
    return kNone;
  return sampleAt (
      intensity, static_cast<float> (u) + way[0], static_cast<float> (v) + way[1]);
}

/** Inverse depth of the frame that is nearest to a point's within a pixel around it, so
 * that outlines may lie a little beside; 0 where the pixel has none. */
float
nearestDepth (const cv::Mat& inverse_depth, int u, int v, float of_point)
{
  float nearest = inverse_depth.at<float> (v, u);
  if (!(nearest > 0.0f))
    return 0.0f;
  for (int y = std::max (0, v - 1); y <= std::min (inverse_depth.rows - 1, v + 1); ++y)
    for (int x = std::max (0, u - 1); x <= std::min (inverse_depth.cols - 1, u + 1);
         ++x) {
      const float other = inverse_depth.at<float> (y, x);
      if (other > 0.0f && std::abs (other - of_point) < std::abs (nearest - of_point))
        nearest = other;
    }
  return nearest;
}

/** Sums over the pixels of a patch that are seen in both frames. */
struct PatchSums {
  int n{0};
  double x{0}, y{0}, xx{0}, yy{0}, xy{0};

  void
  add (double a, double b)
  {
    ++n;
    x += a;
    y += b;
    xx += a * a;
    yy += b * b;
    xy += a * b;
  }
  /** Mean product of the differences to the means. */
  double
  moment (double sum, double first, double second) const
  {
    return sum / n - first / n * (second / n);
  }
};

/** NaN when too little is seen, or stands out of the noise in neither frame. */
double
correlation (const PatchSums& sums, int enough, double least_deviation)
{
  if (sums.n < enough)
    return kNone;
  const double before = sums.moment (sums.xx, sums.x, sums.x);
  const double after = sums.moment (sums.yy, sums.y, sums.y);
  const double least = least_deviation * least_deviation;
  if (!(std::max (before, after) > least))
    return kNone;
  // Where one is flat, nothing of the other is found.
  const double both = std::sqrt (std::max (before, 0.0) * std::max (after, 0.0));
  return both > 0.0 ? sums.moment (sums.xy, sums.x, sums.y) / both : 0.0;
}

Overlap
overlapOfRow (const cv::Mat& depth, const SceneFlow& flow, int v)
{
  Overlap overlap;
  for (int u = 0; u < flow.flow.cols; ++u) {
    const auto seen = flow.visibility.at<unsigned char> (v, u);
    const cv::Vec2f& way = flow.flow.at<cv::Vec2f> (v, u);
    overlap.points += seen != Visibility::NoDepth ? 1 : 0;
    if (!isKnown (way))
      continue;
    ++overlap.moved;
    if (seen == Visibility::OutOfView)
      continue;
    const int column =
        std::clamp (cvRound (static_cast<float> (u) + way[0]), 0, depth.cols - 1);
    const int row =
        std::clamp (cvRound (static_cast<float> (v) + way[1]), 0, depth.rows - 1);
    overlap.landed += depth.at<float> (row, column) > 0.0f ? 1 : 0;
    overlap.found += seen == Visibility::Visible ? 1 : 0;
  }
  return overlap;
}

PatchSums
sumPatch (const cv::Mat& before,
          const cv::Mat& after,
          const SceneFlow& flow,
          cv::Rect patch)
{
  PatchSums sums;
  for (int v = patch.y; v < patch.y + patch.height; ++v)
    for (int u = patch.x; u < patch.x + patch.width; ++u)
      if (const float other = found (after, flow, u, v); !std::isnan (other))
        sums.add (before.at<float> (v, u), other);
  return sums;
}

} // namespace

Overlap
measureOverlap (const RgbdFrame& current, const SceneFlow& flow, int threads)
{
  const cv::Mat& depth = current.levels()[0].inverse_depth;
  std::vector<Overlap> rows (flow.flow.rows);
  parallelFor (threads, flow.flow.rows, 16, [&] (int v) {
    rows[v] = overlapOfRow (depth, flow, v);
  });
  Overlap sum;
  for (const Overlap& row : rows) {
    sum.points += row.points;
    sum.moved += row.moved;
    sum.landed += row.landed;
    sum.found += row.found;
  }
  return sum;
}

int
countInFront (const RgbdFrame& reference,
              const RgbdFrame& current,
              const OutcomeTuning& tuning,
              const SceneFlow& flow)
{
  const cv::Mat& depth = current.levels()[0].inverse_depth;
  const auto noise = static_cast<float> (
      tuning.significant *
      std::hypot (reference.inverseDepthNoise(), current.inverseDepthNoise()));
  int count = 0;
  for (int v = 0; v < flow.flow.rows; ++v)
    for (int u = 0; u < flow.flow.cols; ++u) {
      const cv::Vec2f& way = flow.flow.at<cv::Vec2f> (v, u);
      const float z = flow.points.at<cv::Vec3f> (v, u)[2] +
                      flow.displacement.at<cv::Vec3f> (v, u)[2];
      const float x = static_cast<float> (u) + way[0];
      const float y = static_cast<float> (v) + way[1];
      if (!(z > 0.0f && x >= 0.0f && y >= 0.0f &&
            x <= static_cast<float> (depth.cols - 1) &&
            y <= static_cast<float> (depth.rows - 1)))
        continue;
      const float seen = nearestDepth (depth, cvRound (x), cvRound (y), 1.0f / z);
      count += seen > 0.0f && 1.0f / z - seen > noise + tuning.near * seen ? 1 : 0;
    }
  return count;
}

Likeness
compareTexture (const RgbdFrame& reference,
                const RgbdFrame& current,
                double intensity_noise,
                const OutcomeTuning& tuning,
                int threads,
                const SceneFlow& flow)
{
  const int side = tuning.patch;
  const cv::Mat& before = reference.levels()[0].intensity;
  const cv::Mat& after = current.levels()[0].intensity;
  if (before.empty() || after.empty())
    return {};
  const int columns = before.cols / side;
  std::vector<double> values (static_cast<std::size_t> (columns) *
                              (before.rows / side));
  parallelFor (threads, static_cast<int> (values.size()), 64, [&] (int i) {
    const cv::Rect patch (i % columns * side, i / columns * side, side, side);
    values[i] = correlation (sumPatch (before, after, flow, patch),
                             tuning.patch_seen,
                             tuning.significant * intensity_noise);
  });
  values.erase (std::remove_if (values.begin(),
                                values.end(),
                                [] (double value) { return std::isnan (value); }),
                values.end());
  if (values.empty())
    return {};
  return {static_cast<int> (values.size()), median (values)};
}

} // namespace pcl_msf
