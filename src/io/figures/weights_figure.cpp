// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "io/base/drawing.h"
#include <pcl_msf/io/figures.h>

#include <array>
#include <cmath>

namespace pcl_msf::io {

namespace {

constexpr int kLegendHeight = 22;
constexpr int kShift = 4; ///< cv draws between pixels with this many bits
constexpr double kDark = 0.6;

/** Connections of one strength, as they are drawn. */
struct Strength {
  double least; ///< weight
  const char* name;
  cv::Scalar color;
  int thickness;
};

// In the order in which they are drawn: what is rare comes last, on top.
const std::array<Strength, 3> kStrengths{{{0.95, "together", {90, 200, 60}, 1},
                                          {0.5, "loose", {40, 220, 250}, 1},
                                          {0.0, "broken", {60, 60, 240}, 1}}};

std::size_t
strengthOf (double weight)
{
  std::size_t i = 0;
  while (i + 1 < kStrengths.size() && !(weight >= kStrengths[i].least))
    ++i;
  return i;
}

/** Where a segment is in the image, in fixed-point pixels. */
bool
place (const SceneFlow& flow, int segment, double scale, cv::Point& at)
{
  if (segment < 0 || segment >= static_cast<int> (flow.segments.size()))
    return false;
  const Eigen::Vector3d& centroid = flow.segments[segment].centroid;
  if (!(centroid.z() > 0.0))
    return false;
  const Eigen::Vector2d pixel = flow.camera.project (centroid);
  if (!pixel.allFinite() || pixel.cwiseAbs().maxCoeff() > 1e5)
    return false;
  const double unit = scale * (1 << kShift);
  at = {static_cast<int> (std::lround (unit * pixel.x())),
        static_cast<int> (std::lround (unit * pixel.y()))};
  return true;
}

} // namespace

cv::Mat
weightsPicture (const cv::Mat& image, const SceneFlow& flow)
{
  const cv::Mat gray =
      asGray (image.empty() ? asBgr (image, flow.labels.size()) : image);
  const double scale = gray.cols < 1000 ? 2.0 : 1.0; // lines need pixels of their own
  cv::Mat picture;
  inThisThread (
      [&] { cv::resize (kDark * gray, picture, {}, scale, scale, cv::INTER_LINEAR); });
  picture = asBgr (picture, {});
  std::array<int, kStrengths.size()> count{};
  for (std::size_t i = 0; i < kStrengths.size(); ++i)
    for (const SegmentPair& pair : flow.pairs) {
      cv::Point a, b;
      if (strengthOf (pair.weight) != i || !place (flow, pair.first, scale, a) ||
          !place (flow, pair.second, scale, b))
        continue;
      ++count[i];
      cv::line (picture,
                a,
                b,
                kStrengths[i].color,
                kStrengths[i].thickness,
                cv::LINE_AA,
                kShift);
    }
  const int height = static_cast<int> (kLegendHeight * scale);
  const int top = picture.rows;
  cv::copyMakeBorder (
      picture, picture, 0, height, 0, 0, cv::BORDER_CONSTANT, cv::Scalar::all (255));
  int x = height / 2;
  const int letters = height / 2 - 1;
  for (std::size_t i = 0; i < kStrengths.size(); ++i) {
    const std::string words =
        std::string (kStrengths[i].name) + ": " + std::to_string (count[i]);
    cv::rectangle (picture,
                   cv::Rect (x, top + height / 4, height / 2, height / 2),
                   kStrengths[i].color,
                   cv::FILLED);
    x += height * 3 / 4;
    x += drawText (
        picture, words, {x, top + height * 3 / 4}, letters, cv::Scalar::all (0));
    x += height;
  }
  return picture;
}

} // namespace pcl_msf::io
