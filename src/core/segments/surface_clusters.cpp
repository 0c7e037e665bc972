// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/surface_clusters.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

constexpr int kIterations = 4; // at every second pixel, before the full one
constexpr float kIntensityScale =
    8.f;                             // intensity 1/8 counts as much as one cluster side
constexpr float kPlaneScale = 0.25f; // four tolerances off the plane count as much
constexpr float kPlaneLimit = 9.0f;  // of the squared plane distance: robust

/** A cluster: centre, plane W = w + du (x - cx) + dv (y - cy), mean intensity. */
struct Cluster {
  float x, y, w, du, dv, intensity;
};

/** Sums over a cluster's pixels, about its old centre. */
struct Sums {
  double n{0}, x{0}, y{0}, i{0}, w{0};
  double xx{0}, xy{0}, yy{0}, xw{0}, yw{0};
};

class Clusterer {
public:
  Clusterer (const FrameLevel& level, double noise, int size, int threads)
  : level_ (level)
  , threads_ (threads)
  , noise_ (static_cast<float> (noise))
  , step_ (static_cast<float> (size))
  , columns_ (std::max (1, (level.width() + size / 2) / size))
  , rows_ (std::max (1, (level.height() + size / 2) / size))
  , labels_ (level.height(), level.width(), CV_32SC1, cv::Scalar (-1))
  {
    seed();
  }

  cv::Mat
  run ()
  {
    for (int i = 0; i < kIterations; ++i) {
      assign (2);
      update (2);
    }
    assign (1);
    return labels_;
  }

private:
  void
  seed ();
  void
  assign (int stride);
  void
  update (int stride);
  int
  nearest (int x, int y, float w, float intensity) const;

  float
  intensityAt (int x, int y) const
  {
    return level_.intensity.empty() ? 0.0f : level_.intensity.at<float> (y, x);
  }

  const FrameLevel& level_;
  int threads_;
  float noise_;
  float step_;
  int columns_;
  int rows_;
  cv::Mat labels_;
  std::vector<Cluster> clusters_;
};

void
Clusterer::seed()
{
  const float dx = static_cast<float> (level_.width()) / columns_;
  const float dy = static_cast<float> (level_.height()) / rows_;
  for (int r = 0; r < rows_; ++r)
    for (int c = 0; c < columns_; ++c) {
      const int x = static_cast<int> ((c + 0.5f) * dx);
      const int y = static_cast<int> ((r + 0.5f) * dy);
      Cluster cluster{static_cast<float> (x), static_cast<float> (y), 0, 0, 0, 0};
      cluster.w = level_.inverse_depth.at<float> (y, x);
      cluster.intensity = intensityAt (x, y);
      const cv::Vec3f n = level_.normals.at<cv::Vec3f> (y, x);
      const PinholeCamera& k = level_.camera;
      const auto along_ray = static_cast<float> (n[0] * (x - k.cx) / k.fx +
                                                 n[1] * (y - k.cy) / k.fy + n[2]);
      if (along_ray < -0.1f) {
        cluster.du = cluster.w * n[0] / (along_ray * static_cast<float> (k.fx));
        cluster.dv = cluster.w * n[1] / (along_ray * static_cast<float> (k.fy));
      }
      clusters_.push_back (cluster);
    }
}

int
Clusterer::nearest (int x, int y, float w, float intensity) const
{
  const int column = std::min (columns_ - 1, x * columns_ / level_.width());
  const int row = std::min (rows_ - 1, y * rows_ / level_.height());
  const float inverse_tolerance = kPlaneScale / surfaceTolerance (w, noise_);
  const float inverse_step = 1.0f / step_;
  float best = 1e30f;
  int label = -1;
  for (int r = std::max (0, row - 1); r <= std::min (rows_ - 1, row + 1); ++r)
    for (int c = std::max (0, column - 1); c <= std::min (columns_ - 1, column + 1);
         ++c) {
      const Cluster& k = clusters_[r * columns_ + c];
      const float dx = static_cast<float> (x) - k.x;
      const float dy = static_cast<float> (y) - k.y;
      const float off = (w - k.w - k.du * dx - k.dv * dy) * inverse_tolerance;
      const float shade = (intensity - k.intensity) * kIntensityScale;
      const float distance = (dx * dx + dy * dy) * inverse_step * inverse_step +
                             std::min (off * off, kPlaneLimit) + shade * shade;
      if (distance < best) {
        best = distance;
        label = r * columns_ + c;
      }
    }
  return label;
}

void
Clusterer::assign (int stride)
{
  const int rows = (level_.height() + stride - 1) / stride;
  parallelFor (threads_, rows, 8, [&] (int row) {
    const int y = row * stride;
    const float* w = level_.inverse_depth.ptr<float> (y);
    int* labels = labels_.ptr<int> (y);
    for (int x = 0; x < level_.width(); x += stride)
      labels[x] = w[x] > 0.0f ? nearest (x, y, w[x], intensityAt (x, y)) : -1;
  });
}

void
Clusterer::update (int stride)
{
  std::vector<Sums> sums (clusters_.size());
  for (int y = 0; y < level_.height(); y += stride)
    for (int x = 0; x < level_.width(); x += stride) {
      const int label = labels_.at<int> (y, x);
      if (label < 0)
        continue;
      const Cluster& k = clusters_[label];
      const float w = level_.inverse_depth.at<float> (y, x);
      const double dx = x - k.x;
      const double dy = y - k.y;
      const auto off = static_cast<float> (w - k.w - k.du * dx - k.dv * dy);
      if (k.w > 0.0f && std::abs (off) > 8.0f * surfaceTolerance (w, noise_))
        continue;
      Sums& s = sums[label];
      s.n += 1;
      s.x += dx;
      s.y += dy;
      s.w += w;
      s.i += intensityAt (x, y);
      s.xx += dx * dx;
      s.xy += dx * dy;
      s.yy += dy * dy;
      s.xw += dx * w;
      s.yw += dy * w;
    }
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    const Sums& s = sums[i];
    if (s.n < 3)
      continue;
    Cluster& k = clusters_[i];
    const double mx = s.x / s.n;
    const double my = s.y / s.n;
    const double mw = s.w / s.n;
    const double xx = s.xx / s.n - mx * mx + 0.1;
    const double yy = s.yy / s.n - my * my + 0.1;
    const double xy = s.xy / s.n - mx * my;
    const double xw = s.xw / s.n - mx * mw;
    const double yw = s.yw / s.n - my * mw;
    const double det = xx * yy - xy * xy;
    k = {static_cast<float> (k.x + mx),
         static_cast<float> (k.y + my),
         static_cast<float> (mw),
         static_cast<float> ((yy * xw - xy * yw) / det),
         static_cast<float> ((xx * yw - xy * xw) / det),
         static_cast<float> (s.i / s.n)};
  }
}

} // namespace

cv::Mat
clusterSurfaces (const FrameLevel& level,
                 double inverse_depth_noise,
                 int size,
                 int threads)
{
  return Clusterer (level, inverse_depth_noise, size, threads).run();
}

} // namespace pcl_msf
