// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/connected_segments.h"

#include "core/segments/surface_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pcl_msf {

namespace {

constexpr float kBreak = 6.0f; // tolerances off the tangent plane that end a surface

/** Disjoint sets of pixels; the smallest index is the root. */
class PixelSets {
public:
  explicit PixelSets (int n) : parent_ (n)
  {
    std::iota (parent_.begin(), parent_.end(), 0);
  }

  int
  root (int i)
  {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void
  join (int a, int b)
  {
    a = root (a);
    b = root (b);
    if (a != b)
      parent_[std::max (a, b)] = std::min (a, b);
  }

private:
  std::vector<int> parent_;
};

/** Slopes of the inverse depth per pixel, from the normals. */
class TangentPlanes {
public:
  TangentPlanes (const FrameLevel& level, double noise)
  : level_ (level)
  , noise_ (static_cast<float> (noise))
  , slopes_ (level.height(), level.width(), CV_32FC2, cv::Scalar (0, 0))
  {
    const PinholeCamera& k = level.camera;
    for (int y = 0; y < level.height(); ++y)
      for (int x = 0; x < level.width(); ++x) {
        const cv::Vec3f n = level.normals.at<cv::Vec3f> (y, x);
        const auto along_ray = static_cast<float> (n[0] * (x - k.cx) / k.fx +
                                                   n[1] * (y - k.cy) / k.fy + n[2]);
        const float w = level.inverse_depth.at<float> (y, x);
        if (along_ray < -0.02f && w > 0.0f)
          slopes_.at<cv::Vec2f> (y, x) = {
              w * n[0] / (along_ray * static_cast<float> (k.fx)),
              w * n[1] / (along_ray * static_cast<float> (k.fy))};
      }
  }

  /** How far two neighbours lie off each other's tangent plane, in tolerances: the
   * smaller of both, as at an edge one of the normals is a mixture. */
  float
  distance (int x0, int y0, int x1, int y1) const
  {
    const float w0 = level_.inverse_depth.at<float> (y0, x0);
    const float w1 = level_.inverse_depth.at<float> (y1, x1);
    const cv::Vec2f s0 = slopes_.at<cv::Vec2f> (y0, x0);
    const cv::Vec2f s1 = slopes_.at<cv::Vec2f> (y1, x1);
    const auto dx = static_cast<float> (x1 - x0);
    const auto dy = static_cast<float> (y1 - y0);
    const float d = w1 - w0;
    const float off0 = std::abs (d - s0[0] * dx - s0[1] * dy);
    const float off1 = std::abs (d - s1[0] * dx - s1[1] * dy);
    return std::min (off0, off1) / surfaceTolerance (std::min (w0, w1), noise_);
  }

private:
  const FrameLevel& level_;
  float noise_;
  cv::Mat slopes_;
};

/** The best neighbour of each part. */
struct Neighbor {
  float distance{1e30f};
  int part{-1};
};

template <typename Visit>
void
forEachEdge (const cv::Mat& labels, const Visit& visit)
{
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      if (labels.at<int> (y, x) < 0)
        continue;
      if (x + 1 < labels.cols && labels.at<int> (y, x + 1) >= 0)
        visit (x, y, x + 1, y);
      if (y + 1 < labels.rows && labels.at<int> (y + 1, x) >= 0)
        visit (x, y, x, y + 1);
    }
}

PixelSets
connectedParts (const cv::Mat& labels, const TangentPlanes& planes)
{
  PixelSets sets (static_cast<int> (labels.total()));
  forEachEdge (labels, [&] (int x0, int y0, int x1, int y1) {
    if (labels.at<int> (y0, x0) == labels.at<int> (y1, x1) &&
        planes.distance (x0, y0, x1, y1) < kBreak)
      sets.join (y0 * labels.cols + x0, y1 * labels.cols + x1);
  });
  return sets;
}

std::vector<int>
partSizes (const cv::Mat& labels, PixelSets& sets)
{
  std::vector<int> sizes (labels.total(), 0);
  for (int i = 0; i < static_cast<int> (labels.total()); ++i)
    if (labels.at<int> (i / labels.cols, i % labels.cols) >= 0)
      ++sizes[sets.root (i)];
  return sizes;
}

/** One round of giving small parts to their best neighbour. \return how many */
int
absorbSmallParts (const cv::Mat& labels,
                  const TangentPlanes& planes,
                  int min_points,
                  PixelSets& sets)
{
  const std::vector<int> sizes = partSizes (labels, sets);
  std::vector<Neighbor> best (labels.total());
  const auto offer = [&] (int part, int other, float distance) {
    if (sizes[part] < min_points && distance < best[part].distance)
      best[part] = {distance, other};
  };
  forEachEdge (labels, [&] (int x0, int y0, int x1, int y1) {
    const int a = sets.root (y0 * labels.cols + x0);
    const int b = sets.root (y1 * labels.cols + x1);
    if (a == b || (sizes[a] >= min_points && sizes[b] >= min_points))
      return;
    const float distance = planes.distance (x0, y0, x1, y1);
    offer (a, b, distance);
    offer (b, a, distance);
  });
  int absorbed = 0;
  for (std::size_t part = 0; part < best.size(); ++part)
    if (best[part].part >= 0) {
      sets.join (static_cast<int> (part), best[part].part);
      ++absorbed;
    }
  return absorbed;
}

} // namespace

cv::Mat
connectSegments (const cv::Mat& labels,
                 const FrameLevel& level,
                 double inverse_depth_noise,
                 int min_points)
{
  const TangentPlanes planes (level, inverse_depth_noise);
  PixelSets sets = connectedParts (labels, planes);
  constexpr int kRounds = 3; // small parts in the middle of small parts
  for (int round = 0; round < kRounds; ++round)
    if (absorbSmallParts (labels, planes, min_points, sets) == 0)
      break;
  // Isolated small parts go back to one common part per label.
  const std::vector<int> sizes = partSizes (labels, sets);
  cv::Mat result (labels.size(), CV_32SC1, cv::Scalar (-1));
  const int pixels = static_cast<int> (labels.total());
  for (int i = 0; i < pixels; ++i) {
    const int label = labels.at<int> (i / labels.cols, i % labels.cols);
    if (label < 0)
      continue;
    const int root = sets.root (i);
    result.at<int> (i / labels.cols, i % labels.cols) =
        sizes[root] >= min_points ? root : pixels + label;
  }
  return result;
}

} // namespace pcl_msf
