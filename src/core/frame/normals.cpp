// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/normals.h"

#include "core/base/order_statistics.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr int kRun = 128; // pixels worked on at a time

/** Half width of the window in which slopes reach the aimed accuracy: the slope over a
 * (2r+1)^2 window has standard deviation sigma / sqrt (sum of x^2). */
int
slopeRadius (double focal,
             double noise,
             double typical_inverse_depth,
             const NormalTuning& tuning)
{
  for (int r = 1; r < tuning.max_radius; r *= 2) {
    const double side = 2.0 * r + 1.0;
    const double sum_of_squares = side * r * (r + 1.0) * side / 3.0;
    if (focal * noise / (typical_inverse_depth * std::sqrt (sum_of_squares)) <
        tuning.error)
      return r;
  }
  return tuning.max_radius;
}

struct Slope {
  float du{0.0f};
  float dv{0.0f};
  bool known{false};
};

/** Sums of least-squares planes through the inverse depth of some pixels of a row. */
struct SlopeSums {
  float xx[kRun], xy[kRun], yy[kRun], xw[kRun], yw[kRun];

  Slope
  solve (int i) const
  {
    const float det = xx[i] * yy[i] - xy[i] * xy[i];
    if (det < 0.5f)
      return {};
    return {(yy[i] * xw[i] - xy[i] * yw[i]) / det,
            (xx[i] * yw[i] - xy[i] * xw[i]) / det,
            true};
  }
};

/** 1 where a condition holds, else 0: keeps the loop free of branches. */
[[gnu::always_inline]] inline float
mask (bool condition)
{
  return condition ? 1.0f : 0.0f;
}

/** Adds the pixels at an offset and across the centre where they are on the centre's
 * surface: those that differ little from it, and those that differ much but oppositely,
 * as on a floor seen at a grazing angle.
 * \param straight, mirrored the rows of both, at the first pixel */
[[gnu::always_inline]] inline void
addPixels (const float* center,
           const float* straight,
           const float* mirrored,
           int n,
           float dx,
           float dy,
           float noise,
           const NormalTuning& tuning,
           SlopeSums& sums)
{
  const float same_surface = tuning.same_surface;
  const float steep = tuning.steepest;
  const float known_noise = tuning.noise_sigmas * noise;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const float w = center[i];
    const float share = same_surface * w;
    const float tolerance = known_noise < share ? share : known_noise;
    const float steepest = steep * w;
    const float there = straight[i] - w;
    const float across = mirrored[i] - w;
    const float known_there = mask (straight[i] > 0.0f);
    const float known_across = mask (mirrored[i] > 0.0f);
    const float line =
        known_there * known_across * mask (std::abs (there + across) < tolerance) *
        mask (std::abs (there) < steepest) * mask (std::abs (across) < steepest);
    const float near_there = known_there * mask (std::abs (there) < tolerance);
    const float near_across = known_across * mask (std::abs (across) < tolerance);
    const float use_there = near_there > line ? near_there : line;
    const float use_across = near_across > line ? near_across : line;
    const float by = use_there * there;
    const float back = use_across * across;
    sums.xx[i] = sums.xx[i] + use_there * dx * dx + use_across * dx * dx;
    sums.xy[i] = sums.xy[i] + use_there * dx * dy + use_across * dx * dy;
    sums.yy[i] = sums.yy[i] + use_there * dy * dy + use_across * dy * dy;
    sums.xw[i] = sums.xw[i] + dx * by - dx * back;
    sums.yw[i] = sums.yw[i] + dy * by - dy * back;
  }
}

/** The windows around n pixels of a row. */
struct WindowRow {
  const float* center;   ///< in an image with a border of `radius` pixels of zeros
  std::ptrdiff_t stride; ///< of its rows, floats
  int n;
  int radius;
  float noise;
  const NormalTuning* tuning;
  SlopeSums* sums;
};

[[gnu::always_inline]] inline void
sumRow (const WindowRow& row)
{
  *row.sums = {};
  const int step =
      row.radius > 2 ? 2 : 1; // every second pixel of a wide window will do
  for (int dy = 0; dy <= row.radius; dy += step)
    for (int dx = dy == 0 ? step : -row.radius; dx <= row.radius; dx += step)
      addPixels (row.center,
                 row.center + dy * row.stride + dx,
                 row.center - dy * row.stride - dx,
                 row.n,
                 static_cast<float> (dx),
                 static_cast<float> (dy),
                 row.noise,
                 *row.tuning,
                 *row.sums);
}

PCL_MSF_VERSIONS (sumWindows, sumRow, WindowRow)

float
medianInverseDepth (const cv::Mat& w)
{
  std::vector<float> values;
  for (int y = 0; y < w.rows; y += 8)
    for (int x = 0; x < w.cols; x += 8)
      if (w.at<float> (y, x) > 0.0f)
        values.push_back (w.at<float> (y, x));
  if (values.empty())
    return 1.0f;
  return median (values);
}

/** Zero without a slope. */
cv::Vec3f
normalOf (const Slope& s, float center, int x, int y, const PinholeCamera& camera)
{
  if (!s.known)
    return {0.0f, 0.0f, 0.0f};
  const cv::Vec3f n (static_cast<float> (camera.fx) * s.du,
                     static_cast<float> (camera.fy) * s.dv,
                     center - s.du * static_cast<float> (x - camera.cx) -
                         s.dv * static_cast<float> (y - camera.cy));
  const float length = std::sqrt (n.dot (n));
  return length > 0.0f ? n * (-1.0f / length) : cv::Vec3f (0.0f, 0.0f, 0.0f);
}

} // namespace

cv::Mat
normalsByCentralDifferences (const cv::Mat& w,
                             const PinholeCamera& camera,
                             double noise,
                             const NormalTuning& tuning,
                             InstructionSet set)
{
  cv::Mat normals = cv::Mat::zeros (w.size(), CV_32FC3);
  const int radius = slopeRadius (camera.fx, noise, medianInverseDepth (w), tuning);
  cv::Mat bordered (w.rows + 2 * radius, w.cols + 2 * radius, CV_32FC1, cv::Scalar (0));
  w.copyTo (bordered (cv::Rect ({radius, radius}, w.size())));
  const auto stride = static_cast<std::ptrdiff_t> (bordered.cols);
  SlopeSums sums;
  for (int y = 0; y < w.rows; ++y)
    for (int first = 0; first < w.cols; first += kRun) {
      const int n = std::min (kRun, w.cols - first);
      const float* center = bordered.ptr<float> (y + radius) + radius + first;
      sumWindows (
          {center, stride, n, radius, static_cast<float> (noise), &tuning, &sums}, set);
      cv::Vec3f* out = normals.ptr<cv::Vec3f> (y) + first;
      for (int i = 0; i < n; ++i)
        if (center[i] > 0.0f)
          out[i] = normalOf (sums.solve (i), center[i], first + i, y, camera);
    }
  return normals;
}

cv::Mat
halveNormals (const cv::Mat& normals)
{
  cv::Mat result ((normals.rows + 1) / 2, (normals.cols + 1) / 2, CV_32FC3);
  for (int y = 0; y < result.rows; ++y)
    for (int x = 0; x < result.cols; ++x)
      result.at<cv::Vec3f> (y, x) = normals.at<cv::Vec3f> (2 * y, 2 * x);
  return result;
}

} // namespace pcl_msf
