// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/segment_pixels.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** Where each segment's points begin, and the pixels in that order. */
void
sortBySegment (const cv::Mat& labels, int segments, SegmentPixels& out)
{
  out.begin.assign (segments + 1, 0);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (labels.at<int> (y, x) >= 0)
        ++out.begin[labels.at<int> (y, x) + 1];
  for (int k = 0; k < segments; ++k)
    out.begin[k + 1] += out.begin[k];
  out.pixel.resize (out.begin[segments]);
  std::vector<int> next (out.begin.begin(), out.begin.end() - 1);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (labels.at<int> (y, x) >= 0)
        out.pixel[next[labels.at<int> (y, x)]++] = y * labels.cols + x;
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

/** Scale of the point-to-plane distance and tolerance of the z-test. */
void
fillDepthScales (const FrameLevel& level,
                 const PointOptions& options,
                 int i,
                 SegmentPixels& out)
{
  const Eigen::Vector3f n (out.nx[i], out.ny[i], out.nz[i]);
  const float z = out.z[i];
  const float w = 1.0f / z;
  const Eigen::Vector3f ray (out.x[i] * w, out.y[i] * w, 1.0f);
  const float along_ray = std::abs (n.dot (ray));
  const bool has_normal = along_ray > 0.0f;
  // The depth noise z^2 sigma_w lies along the ray and is seen from the normal; the
  // motion model's own error of some share of a pixel lies across it.
  const float pixel = z / static_cast<float> (level.camera.fx);
  const float across = std::sqrt (std::max (0.0f, 1.0f - n.z() * n.z())) * pixel *
                       static_cast<float> (options.noise.displacement);
  const auto sigma_w = static_cast<float> (options.noise.inverse_depth +
                                           options.noise.relative_depth * w);
  const float along = std::max (along_ray, 0.1f) * z * z * sigma_w;
  out.icp_scale[i] =
      has_normal ? 1.0f / std::sqrt (along * along + across * across) : 0.0f;
  // d W / d pixel on the tangent plane.
  const float slope =
      has_normal
          ? w * n.head<2>().norm() /
                (std::max (along_ray, 0.1f) * static_cast<float> (level.camera.fx))
          : 0.0f;
  out.depth_tolerance[i] =
      options.tuning.hidden_sigmas * static_cast<float> (options.noise.inverse_depth) +
      static_cast<float> (options.relative_tolerance) * w + slope;
}

void
fillPoint (const FrameLevel& level,
           const PointOptions& options,
           int i,
           SegmentPixels& out)
{
  const int u = out.pixel[i] % level.width();
  const int v = out.pixel[i] / level.width();
  const float w = level.inverse_depth.at<float> (v, u);
  const auto rx = static_cast<float> ((u - level.camera.cx) / level.camera.fx);
  const auto ry = static_cast<float> ((v - level.camera.cy) / level.camera.fy);
  const float z = 1.0f / w;
  out.x[i] = rx * z;
  out.y[i] = ry * z;
  out.z[i] = z;
  out.intensity[i] = 0.0f;
  out.brightness_scale[i] = 0.0f;
  if (!level.intensity.empty()) {
    out.intensity[i] =
        options.change.gain * level.intensity.at<float> (v, u) + options.change.offset;
    const auto spread = static_cast<float> (options.noise.displacement);
    const auto sigma = static_cast<float> (options.noise.intensity);
    out.brightness_scale[i] =
        1.0f / std::sqrt (sigma * sigma +
                          spread * spread * squaredGradient (level.intensity, u, v));
  }
  const cv::Vec3f n = level.normals.at<cv::Vec3f> (v, u);
  out.nx[i] = n[0];
  out.ny[i] = n[1];
  out.nz[i] = n[2];
  fillDepthScales (level, options, i, out);
}

} // namespace

SegmentPixels
groupPixels (const FrameLevel& level,
             const cv::Mat& labels,
             int segments,
             const PointOptions& options)
{
  SegmentPixels out;
  sortBySegment (labels, segments, out);
  if (options.max_per_segment > 0)
    thin (options.max_per_segment, options.tuning.least_samples, out);
  resizeArrays (out);
  out.centroid.assign (segments, Eigen::Vector3d::Zero());
  std::atomic<int> brightness_count{0};
  std::atomic<int> icp_count{0};
  parallelFor (options.threads, segments, 16, [&] (int k) {
    int brightness = 0;
    int icp = 0;
    for (int i = out.begin[k]; i < out.begin[k + 1]; ++i) {
      fillPoint (level, options, i, out);
      out.centroid[k] += Eigen::Vector3d (out.x[i], out.y[i], out.z[i]);
      brightness += out.brightness_scale[i] > 0.0f;
      icp += out.icp_scale[i] > 0.0f;
    }
    if (out.size (k) > 0)
      out.centroid[k] /= out.size (k);
    brightness_count += brightness;
    icp_count += icp;
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
