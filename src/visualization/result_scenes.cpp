// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "visualization/closed_cloud.h"
#include "visualization/picture_scenes.h"
#include "visualization/point_colors.h"
#include "visualization/result_checks.h"
#include <pcl_msf/visualization/result_scenes.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::visualization {

namespace {

const cv::Mat&
points (const ResultClouds& result)
{
  return result.scene_flow.points;
}

cv::Mat
warped (const ResultClouds& result)
{
  return displacedPoints (points (result), result.scene_flow.displacement, 1.0);
}

Scene
pairInOwnColors (const ResultClouds& result, const cv::Mat& positions)
{
  requireCurrent (result);
  Scene scene;
  scene.points.push_back (closedCloud (
      points (result), positions, ownColors (result.reference_color, points (result))));
  scene.points.push_back (
      {result.current_points, ownColors (result.current_color, result.current_points)});
  return scene;
}

Scene
pairInTints (const ResultClouds& result,
             const cv::Mat& positions,
             const std::string& name)
{
  requireCurrent (result);
  Scene scene;
  scene.points.push_back (closedCloud (
      points (result),
      positions,
      tintedColors (result.reference_color, points (result), kReferenceTint)));
  scene.points.push_back (
      {result.current_points,
       tintedColors (result.current_color, result.current_points, kCurrentTint)});
  scene.legend = {{kReferenceTint, name}, {kCurrentTint, "current"}};
  scene.blended = true;
  return scene;
}

Scene
warpedAlone (const ResultClouds& result)
{
  Scene scene;
  scene.points.push_back (
      closedCloud (points (result),
                   warped (result),
                   ownColors (result.reference_color, points (result))));
  return scene;
}

Scene
titled (Scene scene, const std::string& title)
{
  scene.title = title;
  return scene;
}

} // namespace

cv::Mat
displacedPoints (const cv::Mat& points, const cv::Mat& displacement, double share)
{
  cv::Mat result (points.size(), CV_32FC3);
  for (int row = 0; row < points.rows; ++row)
    for (int col = 0; col < points.cols; ++col)
      result.at<cv::Vec3f> (row, col) =
          points.at<cv::Vec3f> (row, col) +
          static_cast<float> (share) * displacement.at<cv::Vec3f> (row, col);
  return result;
}

const std::vector<std::pair<std::string, PictureKind>>&
pictureKinds ()
{
  static const std::vector<std::pair<std::string, PictureKind>> kKinds{
      {"before", PictureKind::Before},
      {"after", PictureKind::After},
      {"before_tints", PictureKind::BeforeTints},
      {"after_tints", PictureKind::AfterTints},
      {"warped", PictureKind::Warped},
      {"segments", PictureKind::Segments},
      {"motions", PictureKind::Motions},
      {"arrows", PictureKind::Arrows},
      {"trajectories", PictureKind::Trajectories},
      {"residual", PictureKind::Residual},
      {"depth_residual", PictureKind::DepthResidual},
      {"occlusion", PictureKind::Occlusion}};
  return kKinds;
}

std::string
toString (PictureKind kind)
{
  for (const auto& [name, value] : pictureKinds())
    if (value == kind)
      return name;
  return "unknown";
}

Scene
resultScene (PictureKind kind, const ResultClouds& result, const SceneOptions& options)
{
  requireResult (result);
  switch (kind) {
  case PictureKind::Before:
    return titled (pairInOwnColors (result, points (result)), "before alignment");
  case PictureKind::After:
    return titled (pairInOwnColors (result, warped (result)), "after warping");
  case PictureKind::BeforeTints:
    return titled (pairInTints (result, points (result), "reference"),
                   "before alignment");
  case PictureKind::AfterTints:
    return titled (pairInTints (result, warped (result), "warped reference"),
                   "after warping");
  case PictureKind::Warped:
    return titled (warpedAlone (result), "warped reference");
  case PictureKind::Segments:
    return segmentScene (result);
  case PictureKind::Motions:
    return motionScene (result);
  case PictureKind::Arrows:
    return arrowScene (result, options);
  case PictureKind::Trajectories:
    return trajectoryScene (result, {result.scene_flow.displacement}, options);
  case PictureKind::Residual:
    return residualScene (result, options);
  case PictureKind::DepthResidual:
    return depthResidualScene (result, options);
  case PictureKind::Occlusion:
    return occlusionScene (result);
  }
  return {};
}

Scene
warpScene (const ResultClouds& result,
           const std::vector<cv::Mat>& displacements,
           double t)
{
  requireResult (result);
  requireDisplacements (result, displacements);
  const double last = static_cast<double> (displacements.size());
  const double at = std::clamp (t, 0.0, last);
  const auto next = static_cast<std::size_t> (std::max (1.0, std::ceil (at)));
  const double share = at - static_cast<double> (next - 1);
  cv::Mat displacement = share * displacements[next - 1];
  if (next > 1)
    displacement += (1.0 - share) * displacements[next - 2];
  Scene scene;
  if (!result.current_points.empty()) {
    scene.points.push_back (
        {result.current_points,
         tintedColors (result.current_color, result.current_points, kCurrentTint)});
    scene.legend.push_back ({kCurrentTint, "current"});
  }
  scene.points.push_back (closedCloud (
      points (result),
      displacedPoints (points (result), displacement, 1.0),
      tintedColors (result.reference_color, points (result), kReferenceTint)));
  scene.legend.push_back (
      {kReferenceTint, "reference on its way, frame " + fixedText (at, 2)});
  scene.blended = true;
  return titled (scene, "warp");
}

} // namespace pcl_msf::visualization
