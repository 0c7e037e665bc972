// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include "core/base/number_text.h"
#include "visualization/cloud_light.h"
#include "visualization/point_colors.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/cloud_scenes.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pcl_msf::visualization {

namespace {

constexpr double kAxis = 0.2;       ///< half the length of an axis, of the cloud's size
constexpr double kAxisStep = 0.004; ///< between the lines that make it thick
constexpr int kListedJoints = 6;    ///< that the legend names
const cv::Vec3b kAxisColor (30, 30, 30);

using ColorOf = std::function<cv::Vec3b (std::size_t)>;

/** The finite ones of some points, lit. */
PointSet
litPoints (const std::vector<Eigen::Vector3f>& points, const ColorOf& color)
{
  const CloudLight light (points);
  std::vector<cv::Vec3f> places;
  std::vector<cv::Vec3b> colors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      continue;
    const double bright = light.at (points[i]);
    const cv::Vec3b base = color (i);
    places.emplace_back (points[i].x(), points[i].y(), points[i].z());
    colors.emplace_back (cv::saturate_cast<unsigned char> (bright * base[0]),
                         cv::saturate_cast<unsigned char> (bright * base[1]),
                         cv::saturate_cast<unsigned char> (bright * base[2]));
  }
  return {cv::Mat (places, true).reshape (3, 1), cv::Mat (colors, true).reshape (3, 1)};
}

void
requirePoints (const std::vector<Eigen::Vector3f>& points, const char* what)
{
  if (std::none_of (
          points.begin(), points.end(), [] (const auto& p) { return p.allFinite(); }))
    throw InvalidInput (std::string ("result: the ") + what +
                        " has no points: give its cloud");
}

/** Two clouds over each other, in two tints. */
Scene
tintScene (const std::vector<Eigen::Vector3f>& first,
           const std::vector<Eigen::Vector3f>& second,
           const std::string& title,
           const std::string& first_name)
{
  requirePoints (second, "target");
  Scene scene;
  scene.title = title;
  scene.blended = true;
  scene.points.push_back (
      litPoints (first, [] (std::size_t) { return kReferenceTint; }));
  scene.points.push_back (
      litPoints (second, [] (std::size_t) { return kCurrentTint; }));
  scene.legend = {{kReferenceTint, first_name}, {kCurrentTint, "target"}};
  return scene;
}

/** A bundle of lines, as thick as can be seen. */
void
addAxis (const CloudJoint& joint, double size, Scene& scene)
{
  const Eigen::Vector3d across = joint.axis.unitOrthogonal();
  const Eigen::Vector3d other = joint.axis.cross (across);
  for (int u = -1; u <= 1; ++u)
    for (int v = -1; v <= 1; ++v) {
      const Eigen::Vector3d at =
          joint.point + kAxisStep * size * (u * across + v * other);
      Polyline line;
      for (const double end : {-kAxis, kAxis}) {
        const Eigen::Vector3f p = (at + end * size * joint.axis).cast<float>();
        line.points.emplace_back (p.x(), p.y(), p.z());
        line.colors.push_back (kAxisColor);
      }
      scene.lines.push_back (std::move (line));
    }
}

Scene
partScene (const CloudResult& result)
{
  Scene scene;
  const auto color = [&result] (std::size_t i) {
    return result.part[i] < 0 ? kUnknownColor : lightLabelColor (result.part[i]);
  };
  scene.points.push_back (litPoints (result.source, color));
  const double size = 2.0 * cloudBounds (result.source).radius;
  int listed = 0;
  for (const CloudJoint& joint : result.joints) {
    addAxis (joint, size, scene);
    if (listed++ < kListedJoints)
      scene.legend.push_back ({kAxisColor,
                               "part " + std::to_string (joint.child) + " on " +
                                   std::to_string (joint.parent) + ": " +
                                   fixedText (joint.angle * 180.0 / M_PI, 1) + " deg"});
  }
  int parts = 0;
  for (const int part : result.part)
    parts = std::max (parts, part + 1);
  scene.title = std::to_string (parts) + " parts, " +
                std::to_string (result.joints.size()) + " joints";
  return scene;
}

} // namespace

const std::vector<PictureKind>&
cloudKinds ()
{
  static const std::vector<PictureKind> kinds{PictureKind::BeforeTints,
                                              PictureKind::AfterTints,
                                              PictureKind::Warped,
                                              PictureKind::Motions};
  return kinds;
}

Scene
cloudScene (PictureKind kind, const CloudResult& result)
{
  requirePoints (result.source, "source");
  if (result.warped.size() != result.source.size() ||
      result.part.size() != result.source.size())
    throw InvalidInput ("result: warped and part must be as many as source points");
  switch (kind) {
  case PictureKind::BeforeTints:
    return tintScene (result.source, result.target, "before", "source");
  case PictureKind::AfterTints:
    return tintScene (result.warped, result.target, "after", "source, moved");
  case PictureKind::Warped: {
    Scene scene;
    scene.title = "the source, moved";
    scene.points.push_back (
        litPoints (result.warped, [] (std::size_t) { return kReferenceTint; }));
    return scene;
  }
  case PictureKind::Motions:
    return partScene (result);
  default:
    throw InvalidInput ("result: there is no " + toString (kind) +
                        " of clouds without a grid: take before_tints, after_tints, "
                        "warped or motions");
  }
}

SceneBounds
cloudBounds (const std::vector<Eigen::Vector3f>& points)
{
  Eigen::Vector3f low = Eigen::Vector3f::Constant (INFINITY);
  Eigen::Vector3f high = -low;
  for (const auto& p : points)
    if (p.allFinite()) {
      low = low.cwiseMin (p);
      high = high.cwiseMax (p);
    }
  SceneBounds bounds;
  if (!(low.x() <= high.x()))
    return bounds;
  bounds.center = (0.5F * (low + high)).cast<double>();
  bounds.radius = std::max (1e-12, 0.5 * (high - low).cast<double>().norm());
  bounds.distance = bounds.center.norm();
  return bounds;
}

double
cloudSpacing (const std::vector<Eigen::Vector3f>& points)
{
  requirePoints (points, "cloud");
  return CloudLight (points).spacing();
}

} // namespace pcl_msf::visualization
