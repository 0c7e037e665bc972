// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/closed_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_msf::visualization {

namespace {

constexpr float kStretched = 1.4F; ///< times as far apart as before: a crack
constexpr float kTorn = 12.0F;     ///< spacings apart: no longer one surface
constexpr float kSteepest = 4.0F;  ///< depth between neighbours of a surface, spacings
constexpr float kDepthShare = 0.02F; ///< or a share of the depth: steps of sensors

/** Three neighbours, before and after. */
struct Corner {
  cv::Vec3f before;
  cv::Vec3f after;
};

/** Direction of the line of sight. */
cv::Vec2f
ray (const cv::Vec3f& p)
{
  return {p[0] / p[2], p[1] / p[2]};
}

/** Twice the signed area that a triangle takes in the sensor's picture. */
float
area (const cv::Vec3f& a, const cv::Vec3f& b, const cv::Vec3f& c)
{
  const cv::Vec2f u = ray (b) - ray (a);
  const cv::Vec2f v = ray (c) - ray (a);
  return u[0] * v[1] - u[1] * v[0];
}

enum class Edge { Whole, Stretched, Apart };

Edge
judge (const Corner& a, const Corner& b)
{
  const float depth = std::min (a.before[2], b.before[2]);
  const auto spacing =
      static_cast<float> (depth * cv::norm (ray (a.before) - ray (b.before)));
  const float step = std::abs (a.before[2] - b.before[2]);
  if (step > std::max (kSteepest * spacing, kDepthShare * depth))
    return Edge::Apart;
  const auto before = static_cast<float> (cv::norm (a.before - b.before));
  const auto after = static_cast<float> (cv::norm (a.after - b.after));
  if (after > before + kTorn * spacing)
    return Edge::Apart;
  return after > kStretched * before ? Edge::Stretched : Edge::Whole;
}

/** Does a triangle bridge a crack? Not one that the motion has turned over. */
bool
bridges (const Corner& a, const Corner& b, const Corner& c)
{
  const std::array<Edge, 3> edges{judge (a, b), judge (b, c), judge (c, a)};
  const bool apart = std::count (edges.begin(), edges.end(), Edge::Apart) > 0;
  const bool stretched = std::count (edges.begin(), edges.end(), Edge::Stretched) > 0;
  return stretched && !apart &&
         area (a.before, b.before, c.before) * area (a.after, b.after, c.after) > 0.0F;
}

} // namespace

PointSet
closedCloud (const cv::Mat& points, const cv::Mat& moved, const cv::Mat& colors)
{
  CV_Assert (points.type() == CV_32FC3 && moved.type() == CV_32FC3 &&
             points.size() == moved.size());
  PointSet set{moved, colors};
  const int width = points.cols;
  const auto corner = [&] (int at) -> Corner {
    const int row = at / width;
    const int col = at % width;
    return {points.at<cv::Vec3f> (row, col), moved.at<cv::Vec3f> (row, col)};
  };
  const auto add = [&] (int a, int b, int c) {
    if (bridges (corner (a), corner (b), corner (c)))
      set.triangles.emplace_back (a, b, c);
  };
  for (int row = 0; row + 1 < points.rows; ++row)
    for (int col = 0; col + 1 < width; ++col) {
      const int at = row * width + col;
      add (at, at + 1, at + width);
      add (at + 1, at + width + 1, at + width);
    }
  return set;
}

} // namespace pcl_msf::visualization
