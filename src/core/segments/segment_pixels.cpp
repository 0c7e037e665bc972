// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/segment_pixels.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_msf {

namespace {

/** Calls f (label, pixel) for pixels with a label, in raster order: all, every second
 * one as on a chessboard, or every second one of every second row, shifted in turn. */
template <typename F>
void
forEachLabel (const cv::Mat& labels, int thinning, const F& f)
{
  const int row_step = thinning >= 4 ? 2 : 1;
  const int step = thinning >= 2 ? 2 : 1;
  for (int y = 0; y < labels.rows; y += row_step) {
    const int* row = labels.ptr<int> (y);
    for (int x = y / row_step % step; x < labels.cols; x += step)
      if (row[x] >= 0)
        f (row[x], y * labels.cols + x);
  }
}

/** Halves the thinning of segments of which it would leave fewer than `least` points.
 * \return how many points each has */
std::vector<int>
countPoints (const cv::Mat& labels,
             int thinning,
             int least,
             std::vector<int>& pixels_per_point)
{
  const std::size_t segments = pixels_per_point.size();
  std::vector<int> points (segments, 0);
  bool some = true;
  for (int t = thinning; t > 0 && some; t /= 2) {
    std::vector<int> count (segments, 0);
    forEachLabel (labels, t, [&] (int label, int) { ++count[label]; });
    some = false;
    for (std::size_t k = 0; k < segments; ++k) {
      if (pixels_per_point[k] != t)
        continue;
      points[k] = count[k];
      if (t > 1 && count[k] < least) {
        pixels_per_point[k] = t / 2;
        some = true;
      }
    }
  }
  return points;
}

/** Where each segment's points begin, and the pixels in that order. */
void
sortBySegment (
    const cv::Mat& labels, int segments, int thinning, int least, SegmentPixels& out)
{
  out.pixels_per_point.assign (segments, thinning);
  const std::vector<int> points =
      countPoints (labels, thinning, least, out.pixels_per_point);
  out.begin.assign (segments + 1, 0);
  std::partial_sum (points.begin(), points.end(), out.begin.begin() + 1);
  out.pixel.resize (out.begin[segments]);
  std::vector<int> next (out.begin.begin(), out.begin.end() - 1);
  for (int t = thinning; t > 0; t /= 2)
    if (std::count (out.pixels_per_point.begin(), out.pixels_per_point.end(), t) > 0)
      forEachLabel (labels, t, [&] (int label, int pixel) {
        if (out.pixels_per_point[label] == t)
          out.pixel[next[label]++] = pixel;
      });
}

/** Keeps samples of each segment; more of each when the segments are few. */
void
thin (int max_per_segment, int least_samples, SegmentPixels& out)
{
  const int most =
      std::max (max_per_segment, least_samples / std::max (1, out.segments()));
  std::vector<int> begin (1, 0);
  std::vector<int> pixel;
  for (int k = 0; k < out.segments(); ++k) {
    const int n = out.size (k);
    const int keep = std::min (n, most);
    for (int i = 0; i < keep; ++i)
      pixel.push_back (
          out.pixel[out.begin[k] + static_cast<int> ((i + 0.5) * n / keep)]);
    begin.push_back (static_cast<int> (pixel.size()));
  }
  out.begin.swap (begin);
  out.pixel.swap (pixel);
}

void
resizeArrays (SegmentPixels& out)
{
  const std::size_t n = out.pixel.size() + SegmentPixels::kPadding;
  for (auto* a : {&out.x,
                  &out.y,
                  &out.z,
                  &out.intensity,
                  &out.nx,
                  &out.ny,
                  &out.nz,
                  &out.brightness_scale,
                  &out.icp_scale,
                  &out.depth_tolerance})
    a->resize (n);
}

/** Squared length of the central-difference gradient, per pixel squared. */
float
squaredGradient (const cv::Mat& image, int x, int y)
{
  const int x0 = std::max (0, x - 1);
  const int x1 = std::min (image.cols - 1, x + 1);
  const int y0 = std::max (0, y - 1);
  const int y1 = std::min (image.rows - 1, y + 1);
  const float gx = 0.5f * (image.at<float> (y, x1) - image.at<float> (y, x0));
  const float gy = 0.5f * (image.at<float> (y1, x) - image.at<float> (y0, x));
  return gx * gx + gy * gy;
}

/** What is the same for all points of a level. */
struct PointScales {
  float fx;             ///< pixels
  float displacement;   ///< of the model's error, pixels
  float intensity;      ///< squared noise
  float inverse_depth;  ///< noise, 1 / metres
  float relative_depth; ///< likewise, per inverse depth
  float hidden;         ///< tolerance of the z-test, 1 / metres
  float relative_hidden;
};

PointScales
scalesOf (const FrameLevel& level, const PointOptions& options)
{
  const NoiseModel& noise = options.noise;
  const auto inverse_depth = static_cast<float> (noise.inverse_depth);
  return {static_cast<float> (level.camera.fx),
          static_cast<float> (noise.displacement),
          static_cast<float> (noise.intensity * noise.intensity),
          inverse_depth,
          static_cast<float> (noise.relative_depth),
          options.tuning.hidden_sigmas * inverse_depth,
          static_cast<float> (options.relative_tolerance)};
}

/** Takes a segment's points from the images: as (x, y, z) their rays and inverse depth,
 * as brightness_scale the squared gradient, -1 without intensity. */
void
gatherPoints (const FrameLevel& level,
              const BrightnessChange& change,
              int begin,
              int end,
              SegmentPixels& out)
{
  const double to_x = 1.0 / level.camera.fx;
  const double to_y = 1.0 / level.camera.fy;
  const bool bright = !level.intensity.empty();
  const int width = level.width();
  for (int i = begin; i < end; ++i) {
    const int v = out.pixel[i] / width;
    const int u = out.pixel[i] - v * width;
    out.x[i] = static_cast<float> ((u - level.camera.cx) * to_x);
    out.y[i] = static_cast<float> ((v - level.camera.cy) * to_y);
    out.z[i] = level.inverse_depth.ptr<float> (v)[u];
    out.intensity[i] =
        bright ? change.gain * level.intensity.ptr<float> (v)[u] + change.offset : 0.0f;
    out.brightness_scale[i] = bright ? squaredGradient (level.intensity, u, v) : -1.0f;
    const cv::Vec3f& n = level.normals.ptr<cv::Vec3f> (v)[u];
    out.nx[i] = n[0];
    out.ny[i] = n[1];
    out.nz[i] = n[2];
  }
}

/** Scales of a gathered point's residuals and tolerance of its z-test; then its place.
 */
[[gnu::always_inline]] inline void
scalePoint (const PointScales& s,
            const float (&n)[3],
            float& x,
            float& y,
            float& z,
            float& brightness_scale,
            float& icp_scale,
            float& depth_tolerance)
{
  const float w = z;
  const float depth = 1.0f / w;
  const float along_ray = std::abs (n[0] * x + n[1] * y + n[2]);
  const bool has_normal = along_ray > 0.0f;
  const float least_along = along_ray > 0.1f ? along_ray : 0.1f;
  // The depth noise z^2 sigma_w lies along the ray and is seen from the normal; the
  // motion model's own error of some share of a pixel lies across it.
  const float flat = n[0] * n[0] + n[1] * n[1];
  const float pixel = depth / s.fx * s.displacement;
  const float along =
      least_along * depth * depth * (s.inverse_depth + s.relative_depth * w);
  const float icp = 1.0f / std::sqrt (along * along + flat * pixel * pixel);
  icp_scale = has_normal ? icp : 0.0f;
  // d W / d pixel on the tangent plane.
  const float slope = w * std::sqrt (flat) / (least_along * s.fx);
  depth_tolerance = s.hidden + s.relative_hidden * w + (has_normal ? slope : 0.0f);
  const float square = brightness_scale;
  const float bright = 1.0f / std::sqrt (s.intensity + s.displacement * s.displacement *
                                                           std::abs (square));
  brightness_scale = square >= 0.0f ? bright : 0.0f;
  x *= depth;
  y *= depth;
  z = depth;
}

void
scalePoints (const PointScales& scales, int begin, int end, SegmentPixels& out)
{
  float* const x = out.x.data();
  float* const y = out.y.data();
  float* const z = out.z.data();
  const float* const nx = out.nx.data();
  const float* const ny = out.ny.data();
  const float* const nz = out.nz.data();
  float* const brightness = out.brightness_scale.data();
  float* const icp = out.icp_scale.data();
  float* const tolerance = out.depth_tolerance.data();
#pragma omp simd
  for (int i = begin; i < end; ++i)
    scalePoint (scales,
                {nx[i], ny[i], nz[i]},
                x[i],
                y[i],
                z[i],
                brightness[i],
                icp[i],
                tolerance[i]);
}

Eigen::Matrix3d
spreadOf (const SegmentPixels& points, int segment)
{
  const Eigen::Vector3d center = points.centroid[segment];
  const int begin = points.begin[segment];
  const int end = points.begin[segment + 1];
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
#pragma omp simd reduction(+ : xx, xy, xz, yy, yz, zz)
  for (int i = begin; i < end; ++i) {
    const double x = points.x[i] - center.x();
    const double y = points.y[i] - center.y();
    const double z = points.z[i] - center.z();
    xx += x * x;
    xy += x * y;
    xz += x * z;
    yy += y * y;
    yz += y * z;
    zz += z * z;
  }
  Eigen::Matrix3d moments;
  moments << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return moments / (end - begin);
}

} // namespace

SegmentPixels
groupPixels (const FrameLevel& level,
             const cv::Mat& labels,
             int segments,
             const PointOptions& options)
{
  SegmentPixels out;
  const bool samples = options.max_per_segment > 0;
  const int thinning = samples ? 1 : options.thinning;
  sortBySegment (labels, segments, thinning, options.tuning.least_points, out);
  if (samples)
    thin (options.max_per_segment, options.tuning.least_samples, out);
  resizeArrays (out);
  out.centroid.assign (segments, Eigen::Vector3d::Zero());
  out.spread.assign (segments, Eigen::Matrix3d::Zero());
  std::atomic<int> brightness_count{0};
  std::atomic<int> icp_count{0};
  const PointScales scales = scalesOf (level, options);
  parallelFor (options.threads, segments, 16, [&] (int k) {
    gatherPoints (level, options.change, out.begin[k], out.begin[k + 1], out);
    scalePoints (scales, out.begin[k], out.begin[k + 1], out);
    int brightness = 0;
    int icp = 0;
    for (int i = out.begin[k]; i < out.begin[k + 1]; ++i) {
      out.centroid[k] += Eigen::Vector3d (out.x[i], out.y[i], out.z[i]);
      brightness += out.brightness_scale[i] > 0.0f;
      icp += out.icp_scale[i] > 0.0f;
    }
    if (out.size (k) > 0) {
      out.centroid[k] /= out.size (k);
      out.spread[k] = spreadOf (out, k);
    }
    brightness_count += brightness * out.pixels_per_point[k];
    icp_count += icp * out.pixels_per_point[k];
  });
  out.tolerance_sigmas = options.tuning.hidden_sigmas;
  out.areas = options.noise.areas;
  out.pixel_area = 1 << (2 * options.level);
  out.brightness_count = brightness_count;
  out.icp_count = icp_count;
  return out;
}

cv::Mat
halveLabels (const cv::Mat& labels)
{
  cv::Mat result ((labels.rows + 1) / 2, (labels.cols + 1) / 2, CV_32SC1);
  for (int y = 0; y < result.rows; ++y)
    for (int x = 0; x < result.cols; ++x) {
      const int x1 = std::min (2 * x + 1, labels.cols - 1);
      const int y1 = std::min (2 * y + 1, labels.rows - 1);
      int label = labels.at<int> (2 * y, 2 * x);
      for (const int other : {labels.at<int> (2 * y, x1),
                              labels.at<int> (y1, 2 * x),
                              labels.at<int> (y1, x1)})
        if (label < 0)
          label = other;
      result.at<int> (y, x) = label;
    }
  return result;
}

} // namespace pcl_msf
