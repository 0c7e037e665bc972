// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/cloud_pictures.h"

#include "common/input_files.h"
#include "common/interruption.h"
#include "common/output_folder.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/point_files.h>
#include <pcl_msf/visualization/cloud_scenes.h>
#include <pcl_msf/visualization/offscreen_renderer.h>
#include <pcl_msf/visualization/picture_sheet.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace pcl_msf::tool {

namespace {

using namespace visualization;
namespace fs = std::filesystem;

constexpr double kOverlap = 1.7; // of points: hides most gaps
constexpr double kLargest = 9.0; // pixels, of a point
constexpr int kSheetColumns = 2;

/** How the names of a target's files end: of several that of --frame. */
std::string
endingOf (const RenderOptions& options)
{
  const bool one = fs::exists (fs::path (options.input) / "registered.pcd");
  return one ? "" : "_0_" + std::to_string (options.frame.value_or (1));
}

fs::path
registeredFile (const RenderOptions& options)
{
  return fs::path (options.input) / ("registered" + endingOf (options) + ".pcd");
}

CloudResult
load (const RenderOptions& options)
{
  const fs::path folder = options.input;
  io::RegisteredCloud cloud =
      io::readRegisteredCloud (registeredFile (options).string());
  CloudResult result;
  result.source = std::move (cloud.source);
  result.warped = std::move (cloud.warped);
  result.part = std::move (cloud.part);
  const fs::path joints = folder / ("joints" + endingOf (options) + ".json");
  if (fs::exists (joints))
    result.joints = io::readJoints (joints.string());
  if (!options.sequence.empty())
    result.target = io::readPoints (options.sequence).points;
  return result;
}

/** What is drawn; of `all` and `sheet` what can be. */
std::vector<PictureKind>
kindsOf (const RenderOptions& options, const CloudResult& result)
{
  std::vector<PictureKind> kinds;
  const bool all = options.sheet;
  for (const PictureKind kind : all ? cloudKinds() : options.kinds) {
    const bool needs_target =
        kind == PictureKind::BeforeTints || kind == PictureKind::AfterTints;
    if (!all || !needs_target || !result.target.empty())
      kinds.push_back (kind);
  }
  return kinds;
}

/** With a margin. */
SceneBounds
boundsToSee (const std::vector<Eigen::Vector3f>& points)
{
  if (std::none_of (
          points.begin(), points.end(), [] (const auto& p) { return p.allFinite(); }))
    throw InvalidInput ("result: no point of the source has a known motion; there is "
                        "nothing to draw");
  SceneBounds bounds = cloudBounds (points);
  bounds.radius *= 1.1;
  return bounds;
}

/** The sensor is unknown: a view around the middle. */
View
viewOf (const RenderOptions& o, const SceneBounds& bounds)
{
  View view;
  if (o.view == ViewPreset::Top)
    view = topView (bounds, o.style.size, o.field_of_view, o.zoom);
  else if (o.view == ViewPreset::User)
    view = userView (
        *o.eye, o.target.value_or (bounds.center), o.up, o.style.size, o.field_of_view);
  else
    view = orbitView (
        bounds, o.style.size, o.azimuth, o.elevation, o.field_of_view, o.zoom);
  return o.parallel ? parallelView (view, (bounds.center - view.position).norm())
                    : view;
}

void
checkOptions (const RenderOptions& options)
{
  if (options.animation != Animation::None)
    throw UsageError ("--animation: there is none of clouds without a grid");
  if (!options.sequence.empty() && fs::is_directory (options.sequence))
    throw UsageError ("--sequence: '" + options.sequence +
                      "' is a folder; give the file of the target's cloud");
}

} // namespace

bool
isCloudResult (const RenderOptions& options)
{
  return fs::exists (registeredFile (options));
}

int
renderClouds (const RenderOptions& options)
{
  checkOptions (options);
  const CloudResult result = load (options);
  OutputFolder output (options.output, "pcl_msf_render", fs::canonical (options.input));
  output.keep ([&output] (const std::string&, const std::string& group) {
    return group == output.group();
  });
  const std::vector<PictureKind> kinds = kindsOf (options, result);
  InputFiles inputs;
  inputs.add (options.sequence);
  output.check (inputs, [&] (const std::string& name) {
    return name == "sheet.png" ||
           std::any_of (kinds.begin(), kinds.end(), [&name] (PictureKind kind) {
             return name == toString (kind) + ".png";
           });
  });
  const SceneBounds bounds = boundsToSee (result.source);
  const View view = viewOf (options, bounds);
  PictureStyle style = options.style;
  if (!(style.point_size > 0.0)) {
    const double pixels = view.parallel
                              ? view.scale
                              : view.camera.fx / (bounds.center - view.position).norm();
    style.point_size =
        std::clamp (kOverlap * pixels * cloudSpacing (result.source), 2.0, kLargest);
  }
  OffscreenRenderer renderer;
  std::vector<cv::Mat> pictures;
  std::vector<std::string> names;
  for (const PictureKind kind : kinds) {
    throwIfInterrupted();
    pictures.push_back (renderer.render (cloudScene (kind, result), view, style));
    names.push_back (toString (kind) + ".png");
    io::writeImage ((fs::path (output.stage()) / names.back()).string(),
                    pictures.back());
  }
  if (options.sheet) {
    names.emplace_back ("sheet.png");
    io::writeImage ((fs::path (output.stage()) / names.back()).string(),
                    pictureSheet (pictures, kSheetColumns, style.background));
  }
  output.publish();
  output.finish();
  for (const std::string& name : names)
    if (!options.quiet)
      std::printf ("%s\n", (fs::path (options.output) / name).string().c_str());
  return 0;
}

} // namespace pcl_msf::tool
