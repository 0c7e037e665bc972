// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/number_text.h"
#include "visualization/annotations.h"
#include "visualization/picture_scenes.h"
#include "visualization/point_colors.h"
#include "visualization/result_checks.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::visualization {

namespace {

constexpr double kTypicalShare = 0.99; ///< of the points: motion that is to be seen
constexpr double kSightShare = 0.25;   ///< of motion along the line of sight
constexpr double kPale = 0.6;          ///< share of white in the cloud behind arrows
constexpr double kLeastShare = 0.03;   ///< of the scale: shorter motion has no arrow
constexpr double kMostAcross = 40.0;   ///< arrows side by side
constexpr double kLeastAcross = 18.0;
constexpr double kArrowLength = 1.6; ///< of long arrows, in steps
constexpr int kTimeMap = cv::COLORMAP_PLASMA;
constexpr int kColorMap = cv::COLORMAP_TURBO;

void
requireOptions (const SceneOptions& options)
{
  if (options.arrow_step < 0 || !(options.arrow_scale >= 0.0))
    throw InvalidInput ("arrows: step and scale must not be negative");
}

/** The reference cloud, pale, as the ground that arrows stand on. */
PointSet
paleCloud (const ResultClouds& result)
{
  const cv::Mat& points = result.scene_flow.points;
  cv::Mat gray;
  cv::cvtColor (ownColors (result.reference_color, points), gray, cv::COLOR_BGR2GRAY);
  cv::Mat colors;
  cv::cvtColor (gray * (1.0 - kPale) + 255.0 * kPale, colors, cv::COLOR_GRAY2BGR);
  return {points, colors};
}

cv::Vec3b
colorAt (double share, int color_map)
{
  const cv::Mat level (
      1, 1, CV_8UC1, cv::Scalar (cv::saturate_cast<unsigned char> (255.0 * share)));
  cv::Mat color;
  cv::applyColorMap (level, color, color_map);
  return color.at<cv::Vec3b> (0, 0);
}

/** How arrows or paths are laid out over the picture. */
struct Layout {
  int step{16};         ///< pixels
  double enlarged{1.0}; ///< times the displacement
  double shortest{0.0}; ///< motion below this share of the distance has no path
};

/** How far the points go in the sensor's picture, pixels; NaN = unknown. Motion along
 * the line of sight, which other views show, counts in part. */
cv::Mat
pixelLengths (const SceneFlow& flow, const cv::Mat& displacement)
{
  cv::Mat result (flow.points.size(),
                  CV_32FC1,
                  cv::Scalar (std::numeric_limits<float>::quiet_NaN()));
  for (int row = 0; row < result.rows; ++row)
    for (int col = 0; col < result.cols; ++col) {
      const auto& p = flow.points.at<cv::Vec3f> (row, col);
      const auto& d = displacement.at<cv::Vec3f> (row, col);
      if (!(p[2] > 0.0F))
        continue;
      const double side =
          std::hypot (d[0] - d[2] * p[0] / p[2], d[1] - d[2] * p[1] / p[2]);
      result.at<float> (row, col) = static_cast<float> (
          std::max (side, kSightShare * std::abs (d[2])) * flow.camera.fx / p[2]);
    }
  return result;
}

/** As many as fit beside each other, enlarged where long ones were too short to see. */
Layout
layoutOf (const SceneFlow& flow,
          const cv::Mat& displacement,
          const SceneOptions& options)
{
  const double width = flow.points.cols;
  const double pixels = percentile (
      whereVisible (pixelLengths (flow, displacement), flow.visibility), kTypicalShare);
  Layout layout{options.arrow_step,
                options.arrow_scale,
                2.0 * kLeastShare * pixels / flow.camera.fx};
  if (layout.step == 0)
    layout.step = std::max (
        1,
        cvRound (std::clamp (0.5 * pixels, width / kMostAcross, width / kLeastAcross)));
  if (layout.enlarged == 0.0)
    layout.enlarged =
        pixels > 0.0
            ? std::clamp (roundLength (kArrowLength * layout.step / pixels), 1.0, 100.0)
            : 1.0;
  return layout;
}

/** A scale of lengths, in millimetres when metres were small numbers. */
ColorScale
lengthScale (ColorScale metres)
{
  const bool small = metres.maximum < 0.1;
  metres.maximum *= small ? 1000.0 : 1.0;
  metres.title = small ? "length of displacement [mm]" : "length of displacement [m]";
  return metres;
}

bool
isFinite (const cv::Vec3f& p)
{
  return std::isfinite (p[0] + p[1] + p[2]);
}

/** Pixels from half a step on, so that a grid is centred. */
template <typename Visit>
void
forGrid (const cv::Size& size, int step, const Visit& visit)
{
  for (int row = step / 2; row < size.height; row += step)
    for (int col = step / 2; col < size.width; col += step)
      visit (row, col);
}

} // namespace

Scene
arrowScene (const ResultClouds& result, const SceneOptions& options)
{
  requireOptions (options);
  const SceneFlow& flow = result.scene_flow;
  Scene scene;
  scene.title = "displacement";
  const ColorScale metres =
      colorScale (whereVisible (lengths (flow.displacement), flow.visibility),
                  options.maximum,
                  "",
                  kColorMap);
  const double end = metres.maximum;
  scene.scale = lengthScale (metres);
  const Layout layout = layoutOf (flow, flow.displacement, options);
  if (layout.enlarged != 1.0)
    scene.title += ", arrows " + generalText (layout.enlarged) + " times as long";
  scene.points.push_back (paleCloud (result));
  forGrid (flow.points.size(), layout.step, [&] (int row, int col) {
    const auto& p = flow.points.at<cv::Vec3f> (row, col);
    const auto& d = flow.displacement.at<cv::Vec3f> (row, col);
    const double length = cv::norm (d);
    if (!isFinite (p) || !isFinite (d) || length < kLeastShare * end)
      return;
    const cv::Vec3f tip = p + static_cast<float> (layout.enlarged) * d;
    const double step_here = layout.step * p[2] / flow.camera.fx; // metres
    scene.arrows.push_back (
        {p, tip, colorAt (length / end, kColorMap), static_cast<float> (step_here)});
  });
  return scene;
}

Scene
trajectoryScene (const ResultClouds& result,
                 const std::vector<cv::Mat>& displacements,
                 const SceneOptions& options)
{
  requireResult (result);
  requireOptions (options);
  requireDisplacements (result, displacements);
  const cv::Mat& points = result.scene_flow.points;
  const int frames = static_cast<int> (displacements.size());
  const SceneFlow& flow = result.scene_flow;
  const Layout layout = layoutOf (flow, displacements.back(), options);
  Scene scene;
  scene.title = "trajectories over " + std::to_string (frames + 1) + " frames";
  if (layout.enlarged != 1.0)
    scene.title += ", " + generalText (layout.enlarged) + " times as long";
  scene.points.push_back (paleCloud (result));
  forGrid (points.size(), layout.step, [&] (int row, int col) {
    const auto& p = points.at<cv::Vec3f> (row, col);
    if (!isFinite (p))
      return;
    double reach = 0.0; // as far as it goes from its start, metres
    Polyline line{{p}, {colorAt (0.0, kTimeMap)}};
    for (int k = 0; k < frames; ++k) {
      const auto& d = displacements[k].at<cv::Vec3f> (row, col);
      if (!isFinite (d))
        break;
      reach = std::max (reach, cv::norm (d));
      line.points.push_back (p + static_cast<float> (layout.enlarged) * d);
      line.colors.push_back (colorAt ((k + 1.0) / frames, kTimeMap));
    }
    if (line.points.size() > 1 && reach > layout.shortest * p[2])
      scene.lines.push_back (line);
  });
  scene.scale = ColorScale{0.0, static_cast<double> (frames), "frame", kTimeMap};
  return scene;
}

} // namespace pcl_msf::visualization
