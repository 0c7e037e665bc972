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

constexpr int kStrip = 32; // rows that a thread works on at a time

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
  Parts (const cv::Mat& labels, const cv::Mat& connections, int threads)
  : part_ (labels.size(), CV_32SC1, cv::Scalar (-1)), sets_ (0)
  {
    DisjointSets pixels = connect (connections, threads);
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

  /** All edges that a small part has with others, in raster order. */
  std::vector<Border>
  borders (const TangentPlanes& planes, int min_points, int threads) const;
  /** One round of giving small parts to their best neighbour. \return how many */
  int
  absorbSmall (const std::vector<Border>& borders, int min_points);
  /** Of each pixel the first one of its part; small parts go back to one common part
   * per label. */
  cv::Mat
  numbered (const cv::Mat& labels, int min_points, int threads);

private:
  /** Runs of connected pixels of a row, then rows with each other. */
  static DisjointSets
  connect (const cv::Mat& connections, int threads)
  {
    DisjointSets sets (static_cast<int> (connections.total()));
    const int strips = (connections.rows + kStrip - 1) / kStrip;
    parallelFor (threads, strips, 1, [&] (int strip) {
      const int end = std::min ((strip + 1) * kStrip, connections.rows);
      for (int y = strip * kStrip; y < end; ++y)
        joinRow (connections, y, sets);
      for (int y = strip * kStrip; y + 1 < end; ++y)
        joinRowWithNext (connections, y, sets);
    });
    for (int y = kStrip - 1; y + 1 < connections.rows; y += kStrip)
      joinRowWithNext (connections, y, sets);
    return sets;
  }
  static void
  joinRow (const cv::Mat& connections, int y, DisjointSets& sets)
  {
    const unsigned char* row = connections.ptr<unsigned char> (y);
    for (int x = 0; x + 1 < connections.cols; ++x)
      if (row[x] & kRight)
        sets.join (y * connections.cols + x, y * connections.cols + x + 1);
  }
  static void
  joinRowWithNext (const cv::Mat& connections, int y, DisjointSets& sets)
  {
    const unsigned char* row = connections.ptr<unsigned char> (y);
    const unsigned char* next = connections.ptr<unsigned char> (y + 1);
    const int begin = y * connections.cols;
    for (int x = 0; x < connections.cols; ++x) {
      const bool known = x > 0 && (row[x - 1] & kDown) && (row[x - 1] & kRight) &&
                         (next[x - 1] & kRight);
      if ((row[x] & kDown) && !known)
        sets.join (begin + x, begin + connections.cols + x);
    }
  }

  cv::Mat part_; ///< CV_32SC1, before any was absorbed; -1 = none
  std::vector<int> first_;
  std::vector<int> size_; ///< of the roots of sets_
  DisjointSets sets_;
};

std::vector<Border>
Parts::borders (const TangentPlanes& planes, int min_points, int threads) const
{
  std::vector<std::vector<Border>> of_row (part_.rows);
  parallelFor (threads, part_.rows, kStrip, [&] (int y) {
    const auto look = [&] (int part, int other, int x, int x1, int y1) {
      if (part >= 0 && other >= 0 && part != other &&
          (size_[part] < min_points || size_[other] < min_points))
        of_row[y].push_back ({part, other, planes.distance (x, y, x1, y1)});
    };
    const int* row = part_.ptr<int> (y);
    const int* next = y + 1 < part_.rows ? part_.ptr<int> (y + 1) : nullptr;
    for (int x = 0; x < part_.cols; ++x) {
      if (x + 1 < part_.cols)
        look (row[x], row[x + 1], x, x + 1, y);
      if (next)
        look (row[x], next[x], x, x, y + 1);
    }
  });
  std::vector<Border> result;
  for (const std::vector<Border>& borders : of_row)
    result.insert (result.end(), borders.begin(), borders.end());
  return result;
}

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

cv::Mat
Parts::numbered (const cv::Mat& labels, int min_points, int threads)
{
  std::vector<int> number (first_.size());
  for (std::size_t part = 0; part < number.size(); ++part) {
    const int root = sets_.root (static_cast<int> (part));
    number[part] = size_[root] >= min_points ? first_[root] : -1;
  }
  const int pixels = labels.rows * labels.cols;
  cv::Mat result (labels.size(), CV_32SC1);
  parallelFor (threads, labels.rows, kStrip, [&] (int y) {
    const int* row = labels.ptr<int> (y);
    const int* part = part_.ptr<int> (y);
    int* out = result.ptr<int> (y);
    for (int x = 0; x < labels.cols; ++x)
      out[x] = row[x] < 0             ? -1
               : number[part[x]] >= 0 ? number[part[x]]
                                      : pixels + row[x];
  });
  return result;
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
               findConnections (labels, planes, tuning.connections.stop, threads),
               threads);
  const std::vector<Border> borders = parts.borders (planes, min_points, threads);
  for (int round = 0; round < tuning.connections.rounds; ++round)
    if (parts.absorbSmall (borders, min_points) == 0)
      break;
  return parts.numbered (labels, min_points, threads);
}

} // namespace pcl_msf
