// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "visualization/closed_cloud.h"
#include "visualization/picture_scenes.h"
#include "visualization/point_colors.h"
#include "visualization/result_checks.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/figures.h>

namespace pcl_msf::visualization {

namespace {

constexpr int kColorMap = cv::COLORMAP_VIRIDIS;

Scene
valuesOnWarped (const ResultClouds& result,
                const cv::Mat& values,
                double maximum,
                const std::string& title)
{
  const SceneFlow& flow = result.scene_flow;
  const cv::Mat known = whereVisible (values, flow.visibility);
  Scene scene;
  scene.scale = colorScale (known, maximum, title, kColorMap);
  scene.points.push_back (
      closedCloud (flow.points,
                   displacedPoints (flow.points, flow.displacement, 1.0),
                   mappedColors (known, scene.scale->maximum, kColorMap)));
  scene.legend = {{kUnknownColor, "not seen in both"}};
  return scene;
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
  const cv::Mat values =
      io::brightnessResidual (result.reference_color, result.current_color, flow.flow);
  Scene scene =
      valuesOnWarped (result, values, options.maximum, "residual [grey levels of 255]");
  scene.title = "brightness residual";
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
  const cv::Mat values = 1000.0 * io::depthResidual (flow, depth);
  Scene scene = valuesOnWarped (result, values, options.maximum, "residual [mm]");
  scene.title = "depth residual";
  return scene;
}

} // namespace pcl_msf::visualization
