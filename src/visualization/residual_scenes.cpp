// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "visualization/point_colors.h"
#include "visualization/result_checks.h"
#include "visualization/value_scenes.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/figures.h>

#include <limits>

namespace pcl_msf::visualization {

namespace {

constexpr double kTypicalShare = 0.99;
constexpr int kColorMap = cv::COLORMAP_VIRIDIS;

Scene
valuesOnWarped (const ResultClouds& result,
                const cv::Mat& values,
                double maximum,
                const std::string& title)
{
  double end = maximum > 0.0 ? maximum : percentile (values, kTypicalShare);
  if (!(end > 0.0))
    end = 1.0;
  const SceneFlow& flow = result.scene_flow;
  Scene scene;
  scene.points.push_back ({displacedPoints (flow.points, flow.displacement, 1.0),
                           mappedColors (values, end, kColorMap)});
  scene.scale = ColorScale{0.0, end, title, kColorMap};
  return scene;
}

/** Values of points that both frames see; what is hidden has no residual. */
cv::Mat
whereVisible (cv::Mat values, const cv::Mat& visibility)
{
  values.setTo (cv::Scalar (std::numeric_limits<float>::quiet_NaN()),
                visibility != static_cast<int> (Visibility::Visible));
  return values;
}

} // namespace

Scene
residualScene (const ResultClouds& result, const SceneOptions& options)
{
  const SceneFlow& flow = result.scene_flow;
  if (result.reference_color.empty() || result.current_color.empty() ||
      flow.flow.empty())
    throw InvalidInput ("result: the brightness residual needs the colours of both "
                        "frames; without, depth_residual is there");
  const cv::Mat values = whereVisible (
      io::brightnessResidual (result.reference_color, result.current_color, flow.flow),
      flow.visibility);
  Scene scene =
      valuesOnWarped (result, values, options.maximum, "residual [grey levels of 255]");
  scene.title = "brightness residual";
  scene.legend = {{kUnknownColor, "not seen in both"}};
  return scene;
}

Scene
depthResidualScene (const ResultClouds& result, const SceneOptions& options)
{
  requireCurrent (result);
  const SceneFlow& flow = result.scene_flow;
  if (flow.flow.empty())
    throw InvalidInput ("result: the depth residual needs the optical flow");
  cv::Mat depth;
  cv::extractChannel (result.current_points, depth, 2);
  const cv::Mat values =
      whereVisible (io::depthResidual (flow, depth), flow.visibility);
  Scene scene =
      valuesOnWarped (result, 1000.0 * values, options.maximum, "residual [mm]");
  scene.title = "depth residual";
  scene.legend = {{kUnknownColor, "not seen in both"}};
  return scene;
}

} // namespace pcl_msf::visualization
