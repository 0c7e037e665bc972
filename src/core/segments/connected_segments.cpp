// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/connected_segments.h"

#include "core/base/disjoint_sets.h"
#include "core/base/parallel_for.h"
#include "core/segments/surface_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pcl_msf {

namespace {

/** Slopes of the inverse depth per pixel, from the normals. */
class TangentPlanes {
public:
  TangentPlanes (const FrameLevel& level,
                 double noise,
                 const SegmentTuning& tuning,
                 int threads)
  : level_ (level)
  , noise_ (static_cast<float> (noise))
  , tuning_ (tuning)
  , slopes_ (level.height(), level.width(), CV_32FC2)
  {
    parallelFor (threads, level.height(), 16, [&] (int y) { fillRow (y); });
  }

  /** How far two neighbours lie off each other's tangent plane, in tolerances: the
   * smaller of both, as at an edge one of the normals is a mixture. */
  float
  distance (int x0, int y0, int x1, int y1) const
  {
    const float w0 = level_.inverse_depth.ptr<float> (y0)[x0];
    const float w1 = level_.inverse_depth.ptr<float> (y1)[x1];
    const cv::Vec2f& s0 = slopes_.ptr<cv::Vec2f> (y0)[x0];
    const cv::Vec2f& s1 = slopes_.ptr<cv::Vec2f> (y1)[x1];
    const auto dx = static_cast<float> (x1 - x0);
    const auto dy = static_cast<float> (y1 - y0);
    const float d = w1 - w0;
    const float off0 = std::abs (d - s0[0] * dx - s0[1] * dy);
    const float off1 = std::abs (d - s1[0] * dx - s1[1] * dy);
    return std::min (off0, off1) /
           surfaceTolerance (std::min (w0, w1), noise_, tuning_);
  }

private:
  void
  fillRow (int y)
  {
    const PinholeCamera& k = level_.camera;
    const cv::Vec3f* normals = level_.normals.ptr<cv::Vec3f> (y);
    const float* inverse_depth = level_.inverse_depth.ptr<float> (y);
    cv::Vec2f* slopes = slopes_.ptr<cv::Vec2f> (y);
    for (int x = 0; x < level_.width(); ++x) {
      const cv::Vec3f& n = normals[x];
      const auto along_ray = static_cast<float> (n[0] * (x - k.cx) / k.fx +
                                                 n[1] * (y - k.cy) / k.fy + n[2]);
      const float w = inverse_depth[x];
      slopes[x] = along_ray < -0.02f && w > 0.0f
                      ? cv::Vec2f (w * n[0] / (along_ray * static_cast<float> (k.fx)),
                                   w * n[1] / (along_ray * static_cast<float> (k.fy)))
                      : cv::Vec2f (0.0f, 0.0f);
    }
  }

  const FrameLevel& level_;
  float noise_;
  const SegmentTuning& tuning_;
  cv::Mat slopes_;
};

/** Bits of a pixel: is it connected with the next one of its row, of its column? */
constexpr unsigned char kRight = 1;
constexpr unsigned char kDown = 2;

cv::Mat
findConnections (const cv::Mat& labels,
                 const TangentPlanes& planes,
                 float stop,
                 int threads)
{
  cv::Mat result (labels.size(), CV_8UC1);
  parallelFor (threads, labels.rows, 16, [&] (int y) {
    const int* row = labels.ptr<int> (y);
    const int* next = y + 1 < labels.rows ? labels.ptr<int> (y + 1) : nullptr;
    unsigned char* out = result.ptr<unsigned char> (y);
    for (int x = 0; x < labels.cols; ++x) {
      out[x] = 0;
      if (row[x] < 0)
        continue;
      if (x + 1 < labels.cols && row[x + 1] == row[x] &&
          planes.distance (x, y, x + 1, y) < stop)
        out[x] |= kRight;
      if (next && next[x] == row[x] && planes.distance (x, y, x, y + 1) < stop)
        out[x] |= kDown;
    }
  });
  return result;
}

/** An edge between pixels of two parts that have labels. */
struct Border {
  int part, other;
  float distance;
};

/** The parts of an image, numbered by their first pixels. */
class Parts {
public:
  Parts (const cv::Mat& labels, const cv::Mat& connections)
  : part_ (labels.size(), CV_32SC1, cv::Scalar (-1)), sets_ (0)
  {
    DisjointSets pixels = connect (labels, connections);
    for (int y = 0; y < labels.rows; ++y) {
      const int* row = labels.ptr<int> (y);
      int* part = part_.ptr<int> (y);
      for (int x = 0; x < labels.cols; ++x) {
        if (row[x] < 0)
          continue;
        const int i = y * labels.cols + x;
        const bool same = x > 0 && (connections.ptr<unsigned char> (y)[x - 1] & kRight);
        const int first = same ? -1 : pixels.root (i);
        if (first == i) {
          first_.push_back (i);
          size_.push_back (0);
        }
        part[x] = same         ? part[x - 1]
                  : first == i ? static_cast<int> (first_.size()) - 1
                               : part_.ptr<int>()[first];
        ++size_[part[x]];
      }
    }
    sets_ = DisjointSets (static_cast<int> (first_.size()));
  }

  int
  partOf (int y, int x)
  {
    return sets_.root (part_.ptr<int> (y)[x]);
  }
  int
  firstPixel (int part) const
  {
    return first_[part];
  }
  int
  size (int part) const
  {
    return size_[part];
  }

  std::vector<Border>
  borders (const TangentPlanes& planes, int min_points) const;
  int
  absorbSmall (const std::vector<Border>& borders, int min_points);

private:
  /** Runs of connected pixels of a row, then rows with each other. */
  static DisjointSets
  connect (const cv::Mat& labels, const cv::Mat& connections)
  {
    DisjointSets sets (static_cast<int> (labels.total()));
    for (int y = 0; y < labels.rows; ++y) {
      const unsigned char* row = connections.ptr<unsigned char> (y);
      const unsigned char* next =
          y + 1 < labels.rows ? connections.ptr<unsigned char> (y + 1) : nullptr;
      const int begin = y * labels.cols;
      for (int x = 0; x < labels.cols; ++x) {
        if (row[x] & kRight)
          sets.join (begin + x, begin + x + 1);
        const bool known = x > 0 && (row[x - 1] & kDown) && (row[x - 1] & kRight) &&
                           (next && (next[x - 1] & kRight));
        if ((row[x] & kDown) && !known)
          sets.join (begin + x, begin + labels.cols + x);
      }
    }
    return sets;
  }

  cv::Mat part_; ///< CV_32SC1, before any was absorbed; -1 = none
  std::vector<int> first_;
  std::vector<int> size_; ///< of the roots of sets_
  DisjointSets sets_;
};

/** All edges that a small part has with others, in raster order. */
std::vector<Border>
Parts::borders (const TangentPlanes& planes, int min_points) const
{
  std::vector<Border> result;
  const auto look = [&] (int part, int other, int x, int y, int x1, int y1) {
    if (part >= 0 && other >= 0 && part != other &&
        (size_[part] < min_points || size_[other] < min_points))
      result.push_back ({part, other, planes.distance (x, y, x1, y1)});
  };
  for (int y = 0; y < part_.rows; ++y) {
    const int* row = part_.ptr<int> (y);
    const int* next = y + 1 < part_.rows ? part_.ptr<int> (y + 1) : nullptr;
    for (int x = 0; x < part_.cols; ++x) {
      if (x + 1 < part_.cols)
        look (row[x], row[x + 1], x, y, x + 1, y);
      if (next)
        look (row[x], next[x], x, y, x, y + 1);
    }
  }
  return result;
}

/** One round of giving small parts to their best neighbour. \return how many */
int
Parts::absorbSmall (const std::vector<Border>& borders, int min_points)
{
  struct Neighbor {
    float distance{1e30f};
    int part{-1};
  };
  std::vector<Neighbor> best (first_.size());
  const auto offer = [&] (int part, int other, float distance) {
    if (size_[part] < min_points && distance < best[part].distance)
      best[part] = {distance, other};
  };
  for (const Border& border : borders) {
    const int a = sets_.root (border.part);
    const int b = sets_.root (border.other);
    if (a == b)
      continue;
    offer (a, b, border.distance);
    offer (b, a, border.distance);
  }
  int absorbed = 0;
  for (std::size_t part = 0; part < best.size(); ++part)
    if (best[part].part >= 0) {
      sets_.join (static_cast<int> (part), best[part].part);
      ++absorbed;
    }
  for (std::size_t part = 0; part < best.size(); ++part)
    if (const int root = sets_.root (static_cast<int> (part));
        root != static_cast<int> (part)) {
      size_[root] += size_[part];
      size_[part] = 0;
    }
  return absorbed;
}

} // namespace

cv::Mat
connectSegments (const cv::Mat& labels,
                 const FrameLevel& level,
                 double inverse_depth_noise,
                 int min_points,
                 const SegmentTuning& tuning,
                 int threads)
{
  const TangentPlanes planes (level, inverse_depth_noise, tuning, threads);
  Parts parts (labels,
               findConnections (labels, planes, tuning.connections.stop, threads));
  const std::vector<Border> borders = parts.borders (planes, min_points);
  for (int round = 0; round < tuning.connections.rounds; ++round)
    if (parts.absorbSmall (borders, min_points) == 0)
      break;
  // Isolated small parts go back to one common part per label.
  cv::Mat result (labels.size(), CV_32SC1);
  const int pixels = labels.rows * labels.cols;
  for (int y = 0; y < labels.rows; ++y) {
    const int* row = labels.ptr<int> (y);
    int* out = result.ptr<int> (y);
    for (int x = 0; x < labels.cols; ++x) {
      const int part = row[x] < 0 ? -1 : parts.partOf (y, x);
      out[x] = part < 0                          ? -1
               : parts.size (part) >= min_points ? parts.firstPixel (part)
                                                 : pixels + row[x];
    }
  }
  return result;
}

} // namespace pcl_msf
