// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/order_statistics.h"
#include <pcl_msf/io/flow_color.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pcl_msf::io {

namespace {

constexpr int kHues = 55;
constexpr double kTypicalShare = 0.99;
constexpr double kPi = 3.14159265358979323846;

/** One sixth of the wheel: from one pure hue to the next in so many steps. */
struct Sector {
  int steps;
  std::array<int, 3> from; ///< red, green, blue: 0 or 1
  std::array<int, 3> to;
};

/** The wheel of the paper: hues are packed where the eye tells more of them apart. */
std::array<cv::Vec3f, kHues>
makeWheel ()
{
  constexpr std::array<Sector, 6> kSectors{{{15, {1, 0, 0}, {1, 1, 0}},
                                            {6, {1, 1, 0}, {0, 1, 0}},
                                            {4, {0, 1, 0}, {0, 1, 1}},
                                            {11, {0, 1, 1}, {0, 0, 1}},
                                            {13, {0, 0, 1}, {1, 0, 1}},
                                            {6, {1, 0, 1}, {1, 0, 0}}}};
  std::array<cv::Vec3f, kHues> wheel;
  int hue = 0;
  for (const Sector& sector : kSectors)
    for (int step = 0; step < sector.steps; ++step, ++hue)
      for (int c = 0; c < 3; ++c) {
        const float t = static_cast<float> (step) / static_cast<float> (sector.steps);
        wheel[hue][c] = static_cast<float> (sector.from[c]) * (1.0F - t) +
                        static_cast<float> (sector.to[c]) * t;
      }
  return wheel;
}

/** Colour of a flow in units of the maximum. */
cv::Vec3b
colorOf (double u, double v)
{
  static const auto wheel = makeWheel();
  const double length = std::hypot (u, v);
  const double turn = std::atan2 (-v, -u) / kPi; // -1 .. 1, as in the paper's figure
  const double position = (turn + 1.0) / 2.0 * (kHues - 1);
  const int first = static_cast<int> (position);
  const int second = (first + 1) % kHues;
  const double t = position - first;
  cv::Vec3b bgr;
  for (int c = 0; c < 3; ++c) {
    const double hue = (1.0 - t) * wheel[first][c] + t * wheel[second][c];
    const double value = length <= 1.0 ? 1.0 - length * (1.0 - hue) : 0.75 * hue;
    bgr[2 - c] = static_cast<unsigned char> (std::floor (255.0 * value));
  }
  return bgr;
}

bool
isKnown (const cv::Vec2f& flow)
{
  return std::isfinite (flow[0]) && std::isfinite (flow[1]);
}

} // namespace

double
flowLength (const cv::Mat& flow, double share)
{
  std::vector<double> lengths;
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const auto& f = flow.at<cv::Vec2f> (row, col);
      if (isKnown (f))
        lengths.push_back (std::hypot (double{f[0]}, double{f[1]}));
    }
  if (lengths.empty())
    return 0.0;
  const double last = static_cast<double> (lengths.size() - 1);
  return nthSmallest (lengths, std::lround (std::clamp (share, 0.0, 1.0) * last));
}

cv::Mat
flowColors (const cv::Mat& flow, double maximum)
{
  CV_Assert (flow.type() == CV_32FC2);
  const double full = maximum > 0.0 ? maximum : flowLength (flow, kTypicalShare);
  // Flow of exactly that length must not darken by a rounding error.
  const double scale = full > 0.0 ? (1.0 - 1e-9) / full : 0.0;
  cv::Mat colors (flow.size(), CV_8UC3, cv::Scalar::all (0));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const auto& f = flow.at<cv::Vec2f> (row, col);
      if (isKnown (f))
        colors.at<cv::Vec3b> (row, col) = colorOf (scale * f[0], scale * f[1]);
    }
  return colors;
}

cv::Mat
flowWheel (int size)
{
  CV_Assert (size > 0);
  cv::Mat wheel (size, size, CV_8UC3, cv::Scalar::all (255));
  const double radius = 0.5 * size;
  for (int row = 0; row < size; ++row)
    for (int col = 0; col < size; ++col) {
      const double u = (col + 0.5 - radius) / radius;
      const double v = (row + 0.5 - radius) / radius;
      if (std::hypot (u, v) <= 1.0)
        wheel.at<cv::Vec3b> (row, col) = colorOf (u, v);
    }
  return wheel;
}

} // namespace pcl_msf::io
