// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/drawing.h"
#include "io/base/label_colors.h"
#include "io/base/motion_ranks.h"
#include "visualization/picture_scenes.h"
#include "visualization/point_colors.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <array>
#include <functional>

namespace pcl_msf::visualization {

namespace {

constexpr double kTexture = 0.5; ///< share of the image's light in a label's colour
constexpr double kLine = 0.45;   ///< light of the lines between labels
constexpr int kListedGroups = 6; ///< motion groups that the legend names
const cv::Vec3b kLargestGroup (190, 190, 190);

/** A colour per label with the image's light and dark in it. */
cv::Mat
colorsOfLabels (const cv::Mat& labels,
                const cv::Mat& image,
                const cv::Mat& points,
                const std::function<cv::Vec3b (int)>& color)
{
  const cv::Mat light = io::asGray (ownColors (image, points));
  cv::Mat brightness;
  light.convertTo (brightness, CV_32FC1);
  const double white = std::max (64.0, percentile (brightness, 0.95));
  cv::Mat colors (labels.size(), CV_8UC3);
  for (int row = 0; row < labels.rows; ++row)
    for (int col = 0; col < labels.cols; ++col) {
      const int label = labels.at<int> (row, col);
      const double share = std::min (1.0, light.at<unsigned char> (row, col) / white);
      const double shade = (1.0 - kTexture + kTexture * share) *
                           (io::onBoundary (labels, row, col) ? kLine : 1.0);
      const cv::Vec3b base = label >= 0 ? color (label) : kUnknownColor;
      for (int c = 0; c < 3; ++c)
        colors.at<cv::Vec3b> (row, col)[c] =
            cv::saturate_cast<unsigned char> (shade * base[c]);
    }
  return colors;
}

std::string
percent (long part, long whole)
{
  const long tenths = whole > 0 ? (1000 * part + whole / 2) / whole : 0;
  return std::to_string (tenths / 10) + "." + std::to_string (tenths % 10) + " %";
}

} // namespace

Scene
segmentScene (const ResultClouds& result)
{
  const SceneFlow& flow = result.scene_flow;
  double highest = -1.0;
  cv::minMaxLoc (flow.labels, nullptr, &highest);
  const auto segments =
      std::max (flow.segments.size(), static_cast<std::size_t> (highest + 1.0));
  Scene scene;
  scene.title = std::to_string (segments) + " segments";
  scene.points.push_back (
      {flow.points,
       colorsOfLabels (
           flow.labels, result.reference_color, flow.points, lightLabelColor)});
  return scene;
}

Scene
motionScene (const ResultClouds& result)
{
  const SceneFlow& flow = result.scene_flow;
  if (flow.segments.empty())
    throw InvalidInput ("result: it does not say which segments move together; the "
                        "motion groups need a result with bodies_0.png");
  const io::MotionRanks ranks (flow);
  const auto color = [&ranks] (int rank) {
    if (rank == ranks.undetermined())
      return cv::Vec3b (30, 30, 30);
    return rank == 0 ? kLargestGroup : lightLabelColor (rank - 1);
  };
  Scene scene;
  scene.title = std::to_string (flow.groups) + " motion groups";
  scene.points.push_back (
      {flow.points,
       colorsOfLabels (
           ranks.image (flow.labels), result.reference_color, flow.points, color)});
  for (int rank = 0; rank < std::min (kListedGroups, ranks.undetermined()); ++rank)
    scene.legend.push_back ({color (rank),
                             (rank == 0 ? "largest, " : "") +
                                 percent (ranks.points (rank), ranks.allPoints())});
  if (ranks.undetermined() > kListedGroups)
    scene.legend.push_back (
        {kUnknownColor,
         "and " + std::to_string (ranks.undetermined() - kListedGroups) + " smaller"});
  return scene;
}

Scene
occlusionScene (const ResultClouds& result)
{
  struct Kind {
    Visibility code;
    const char* name;
    cv::Vec3b color;
  };
  const std::array<Kind, 4> kinds{
      {{Visibility::Visible, "seen in both", {175, 175, 175}},
       {Visibility::Occluded, "occluded", {40, 40, 220}},
       {Visibility::OutOfView, "out of view", {220, 100, 20}},
       {Visibility::Unknown, "unknown", {40, 190, 230}}}};
  const SceneFlow& flow = result.scene_flow;
  cv::Mat index (flow.visibility.size(), CV_32SC1, cv::Scalar (-1));
  const long known =
      cv::countNonZero (flow.visibility != pixelValue (Visibility::NoDepth));
  Scene scene;
  scene.title = "occlusion";
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const cv::Mat here = flow.visibility == pixelValue (kinds[i].code);
    index.setTo (static_cast<int> (i), here);
    const long count = cv::countNonZero (here);
    if (count > 0)
      scene.legend.push_back (
          {kinds[i].color, kinds[i].name + (", " + percent (count, known))});
  }
  const auto color = [&kinds] (int i) { return kinds[i].color; };
  scene.points.push_back (
      {flow.points,
       colorsOfLabels (index, result.reference_color, flow.points, color)});
  return scene;
}

} // namespace pcl_msf::visualization
