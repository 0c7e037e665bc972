// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/surface_clusters.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

constexpr int kRun = 64; // pixels looked at together

/** A cluster: centre, plane W = w + du (x - cx) + dv (y - cy), mean intensity. */
struct Cluster {
  float x, y, w, du, dv, intensity;
};

/** Sums over a cluster's pixels, about its old centre. */
struct Sums {
  double n{0}, x{0}, y{0}, i{0}, w{0};
  double xx{0}, xy{0}, yy{0}, xw{0}, yw{0};
};

/** Pixels of a row with the same candidates: each loop over them vectorizes. */
struct Run {
  float x[kRun], w[kRun], intensity[kRun], inverse_tolerance[kRun], best[kRun];
  float label[kRun]; ///< a whole number
};

/** A run, and the clusters that its pixels may belong to. */
struct Choice {
  Run* run;
  int n; ///< pixels
  float y;
  const Cluster* clusters;      ///< of the whole grid
  int columns;                  ///< of that
  int top, bottom, left, right; ///< a part of it, inclusive
  float inverse_step;           ///< of the grid, 1 / pixels
  float noise;                  ///< of inverse depth
  const SegmentTuning* tuning;
};

[[gnu::always_inline]] inline void
compareRun (Run& run, int n, const Cluster& k, float label, float dy, const Choice& all)
{
  const float inverse_step = all.inverse_step;
  const float plane_limit = all.tuning->clusters.plane_limit;
  const float intensity_scale = all.tuning->clusters.intensity_scale;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const float dx = run.x[i] - k.x;
    const float off =
        (run.w[i] - k.w - k.du * dx - k.dv * dy) * run.inverse_tolerance[i];
    const float off2 = off * off;
    const float shade = (run.intensity[i] - k.intensity) * intensity_scale;
    const float distance = (dx * dx + dy * dy) * inverse_step * inverse_step +
                           (off2 < plane_limit ? off2 : plane_limit) + shade * shade;
    const float best = run.best[i];
    const float nearer = distance < best ? 1.0f : 0.0f;
    run.best[i] = distance < best ? distance : best;
    run.label[i] += nearer * (label - run.label[i]);
  }
}

[[gnu::always_inline]] inline void
chooseNearest (const Choice& choice)
{
  Run& run = *choice.run;
  const float plane_scale = choice.tuning->clusters.plane_scale;
  for (int i = 0; i < choice.n; ++i) {
    run.inverse_tolerance[i] =
        plane_scale / surfaceTolerance (run.w[i], choice.noise, *choice.tuning);
    run.best[i] = 1e30f;
    run.label[i] = -1.0f;
  }
  for (int r = choice.top; r <= choice.bottom; ++r)
    for (int c = choice.left; c <= choice.right; ++c) {
      const int label = r * choice.columns + c;
      const Cluster k = choice.clusters[label];
      compareRun (run, choice.n, k, static_cast<float> (label), choice.y - k.y, choice);
    }
}

PCL_MSF_VERSIONS (findNearest, chooseNearest, Choice)

class Clusterer {
public:
  Clusterer (const FrameLevel& level,
             double noise,
             int size,
             const SegmentTuning& tuning,
             int threads,
             InstructionSet set)
  : level_ (level)
  , tuning_ (tuning)
  , threads_ (threads)
  , set_ (set)
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
    for (int i = 0; i < tuning_.clusters.iterations; ++i) {
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
  void
  addRow (int y, int stride, int first_label, std::vector<Sums>& sums) const;
  void
  moveTo (const Sums& sums, Cluster& cluster) const;
  void
  assignRow (int y, int stride);
  void
  label (int y, int column, int n, Run& run) const;
  int
  rowOf (int y) const
  {
    return std::min (rows_ - 1, y * rows_ / level_.height());
  }
  int
  columnOf (int x) const
  {
    return std::min (columns_ - 1, x * columns_ / level_.width());
  }

  float
  intensityAt (int x, int y) const
  {
    return level_.intensity.empty() ? 0.0f : level_.intensity.at<float> (y, x);
  }

  const FrameLevel& level_;
  const SegmentTuning& tuning_;
  int threads_;
  InstructionSet set_;
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

/** Labels of n pixels of row y in a column of the seeds' grid: of the nearest among the
 * clusters seeded around. */
void
Clusterer::label (int y, int column, int n, Run& run) const
{
  const int row = rowOf (y);
  findNearest ({&run,
                n,
                static_cast<float> (y),
                clusters_.data(),
                columns_,
                std::max (0, row - 1),
                std::min (rows_ - 1, row + 1),
                std::max (0, column - 1),
                std::min (columns_ - 1, column + 1),
                1.0f / step_,
                noise_,
                &tuning_},
               set_);
}

void
Clusterer::assignRow (int y, int stride)
{
  const float* w = level_.inverse_depth.ptr<float> (y);
  const float* intensity =
      level_.intensity.empty() ? nullptr : level_.intensity.ptr<float> (y);
  int* labels = labels_.ptr<int> (y);
  Run run;
  for (int x = 0; x < level_.width();) {
    const int column = columnOf (x);
    const int first = x;
    int n = 0;
    for (; x < level_.width() && n < kRun && columnOf (x) == column; x += stride, ++n) {
      run.x[n] = static_cast<float> (x);
      run.w[n] = w[x];
      run.intensity[n] = intensity ? intensity[x] : 0.0f;
    }
    label (y, column, n, run);
    for (int i = 0; i < n; ++i)
      labels[first + i * stride] =
          run.w[i] > 0.0f ? static_cast<int> (run.label[i]) : -1;
  }
}

void
Clusterer::assign (int stride)
{
  const int rows = (level_.height() + stride - 1) / stride;
  parallelFor (threads_, rows, 8, [&] (int row) { assignRow (row * stride, stride); });
}

/** A row of clusters at a time: their pixels are in their own and the next rows of the
 * seeds' grid, see findNearest (). */
void
Clusterer::update (int stride)
{
  parallelFor (threads_, rows_, 1, [&] (int row) {
    std::vector<Sums> sums (columns_);
    for (int y = 0; y < level_.height(); y += stride)
      if (std::abs (rowOf (y) - row) <= 1)
        addRow (y, stride, row * columns_, sums);
    for (int column = 0; column < columns_; ++column)
      moveTo (sums[column], clusters_[row * columns_ + column]);
  });
}

/** Adds the pixels of row y that have one of the labels from the first one on. */
void
Clusterer::addRow (int y, int stride, int first_label, std::vector<Sums>& sums) const
{
  const int* labels = labels_.ptr<int> (y);
  const float* inverse_depth = level_.inverse_depth.ptr<float> (y);
  for (int x = 0; x < level_.width(); x += stride) {
    const int label = labels[x];
    if (label < first_label || label >= first_label + columns_)
      continue;
    const Cluster& k = clusters_[label];
    const float w = inverse_depth[x];
    const double dx = x - k.x;
    const double dy = y - k.y;
    const auto off = static_cast<float> (w - k.w - k.du * dx - k.dv * dy);
    if (k.w > 0.0f && std::abs (off) > tuning_.clusters.outlier *
                                           surfaceTolerance (w, noise_, tuning_))
      continue;
    Sums& s = sums[label - first_label];
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
}

void
Clusterer::moveTo (const Sums& s, Cluster& k) const
{
  if (s.n < 3)
    return;
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

} // namespace

cv::Mat
clusterSurfaces (const FrameLevel& level,
                 double inverse_depth_noise,
                 int size,
                 const SegmentTuning& tuning,
                 int threads,
                 InstructionSet set)
{
  return Clusterer (level, inverse_depth_noise, size, tuning, threads, set).run();
}

} // namespace pcl_msf
