// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/option_table.h"

#include "common/ranges.h"
#include "common/recordings.h"

#include <optional>

namespace pcl_msf::tool {

namespace {

bool
parsePoint (const std::string& text, std::optional<Eigen::Vector3d>& point)
{
  double numbers[3];
  if (!parseList (text, ',', numbers))
    return false;
  point = Eigen::Vector3d (numbers[0], numbers[1], numbers[2]);
  return true;
}

bool
parseSize (const std::string& text, RenderOptions& options)
{
  int numbers[2];
  if (!parseList (text, 'x', numbers))
    return false;
  options.style.size = {numbers[0], numbers[1]};
  options.size_given = true;
  return true;
}

bool
parseBackground (const std::string& text, cv::Vec3b& background)
{
  int rgb[3] = {255, 255, 255};
  if (text == "black")
    rgb[0] = rgb[1] = rgb[2] = 0;
  else if (text != "white" && !parseList (text, ',', rgb))
    return false;
  for (int c = 0; c < 3; ++c) {
    if (rgb[c] < 0 || rgb[c] > 255)
      return false;
    background[2 - c] = static_cast<unsigned char> (rgb[c]);
  }
  return true;
}

/** "white", "black" or "R,G,B". */
std::string
backgroundText (const cv::Vec3b& bgr)
{
  if (bgr == cv::Vec3b::all (255) || bgr == cv::Vec3b::all (0))
    return bgr[0] == 0 ? "black" : "white";
  return std::to_string (bgr[2]) + "," + std::to_string (bgr[1]) + "," +
         std::to_string (bgr[0]);
}

std::string
kindNames ()
{
  std::string names;
  for (const auto& kind : visualization::pictureKinds())
    names += kind.first + ", ";
  return names + "sheet (side by side) or all; may be given again";
}

/** "0,-1,0" */
std::string
textOf (const Eigen::Vector3d& point)
{
  return presetText (point.x()) + "," + presetText (point.y()) + "," +
         presetText (point.z());
}

void
addPoint (CLI::App& app,
          const std::string& name,
          const std::string& help,
          std::optional<Eigen::Vector3d>& point)
{
  addOption (app, name, "X,Y,Z", help, [&point] (const std::string& word) {
    return parsePoint (word, point);
  });
}

void
addInputOptions (CLI::App& app, RenderOptions& o)
{
  addText (app,
           "RESULT",
           "FOLDER",
           "what pcl_msf_scene_flow wrote, or frames to be solved first",
           o.input);
  beginGroup (app, "What to read and write");
  addText (
      app,
      "--sequence",
      "FOLDER",
      "frames of a result folder: color_K, depth_K, camera.txt, or a data set's; of "
      "pcl_msf_register's the target's file",
      o.sequence);
  addNumber (app,
             "--reference",
             "R",
             "the frame whose points are followed [the first of a result, else 0]",
             o.reference)
      ->check (atLeast (0));
  addNumber (
      app, "--frame", "K", "the current frame [the one after the reference]", o.frame)
      ->check (atLeast (0));
  addNumber (app,
             "--window",
             "K",
             "last frame of trajectories and of the warp, 0 = --frame",
             o.window)
      ->check (atLeast (0));
  addTexts (app, "--kind", "KIND", kindNames(), o.kind_words)->default_str (kUsualKind);
  addText (app, "--output", "DIR", "folder for KIND.png and so on", o.output);
  addReadingOptions (app, o.reading);
}

void
addViewOptions (CLI::App& app, RenderOptions& o)
{
  beginGroup (app, "From where");
  addWord<ViewPreset> (app,
                       "--view",
                       "user: with --eye and --target",
                       o.view,
                       {{"sensor", ViewPreset::Sensor},
                        {"orbit", ViewPreset::Orbit},
                        {"top", ViewPreset::Top},
                        {"user", ViewPreset::User}});
  addNumber (app, "--azimuth", "DEG", "orbit: to the right", o.azimuth);
  addNumber (app, "--elevation", "DEG", "orbit: upwards, -89 to 89", o.elevation);
  addNumber (app, "--zoom", "FACTOR", "orbit, top: nearer when above 1", o.zoom)
      ->check (above (0));
  addPoint (
      app, "--eye", "user: metres, sensor's frame (x right, y down, z forward)", o.eye);
  addPoint (
      app, "--target", "user: the point looked at [the scene's centre]", o.target);
  const auto take_up = [&o] (const std::string& word) {
    std::optional<Eigen::Vector3d> up;
    if (parsePoint (word, up))
      o.up = *up;
    return up.has_value();
  };
  addOption (app, "--up", "X,Y,Z", "user", take_up, textOf (o.up));
  addNumber (app,
             "--field-of-view",
             "DEG",
             "orbit, top, user: along the larger side",
             o.field_of_view)
      ->check (within (1.0, 170.0));
  addSwitch (
      app, "--parallel", "parallel projection, with a length in metres", o.parallel);
}

void
addStyleOptions (CLI::App& app, RenderOptions& o)
{
  beginGroup (app, "How it looks");
  addOption (app,
             "--size",
             "WxH",
             "pixels, up to 3840x2160 [the sensor's size]",
             [&o] (const std::string& word) { return parseSize (word, o); });
  addNumber (
      app, "--supersampling", "N", "drawn N times larger", o.style.supersampling);
  addNumber (app,
             "--point-size",
             "PX",
             "0 = as large as the gaps between points",
             o.style.point_size);
  addOption (
      app,
      "--background",
      "COLOR",
      "white, black or R,G,B",
      [&o] (const std::string& word) {
        return parseBackground (word, o.style.background);
      },
      backgroundText (o.style.background));
  addSwitch (app, "--axes", "directions of the sensor's frame", o.style.axes);
  addSwitch (app, "--legend", "legend and colour scale", o.style.legend);
  addSwitch (app, "--title", "what the picture shows, in words", o.style.title);
  addNumber (app,
             "--arrow-step",
             "PX",
             "pixels between arrows or trajectories, 0 = as fit",
             o.scene.arrow_step)
      ->check (atLeast (0));
  addNumber (app,
             "--arrow-scale",
             "FACTOR",
             "arrows are so many times the displacement, 0 = as can be seen",
             o.scene.arrow_scale)
      ->check (atLeast (0));
  addNumber (app,
             "--maximum",
             "VALUE",
             "end of the colour scale, 0 = 99th percentile",
             o.scene.maximum);
}

void
addAnimationOptions (CLI::App& app, RenderOptions& o)
{
  beginGroup (app, "Animation");
  auto* animation = addWord<Animation> (
      app,
      "--animation",
      "orbit (around the first --kind) or warp (reference to current and back) as PNG "
      "sequence",
      o.animation,
      {{"orbit", Animation::Orbit}, {"warp", Animation::Warp}});
  addNumber (app,
             "--sweep",
             "DEG",
             "orbit: there and back over so much, 360 = a whole turn",
             o.sweep);
  addNumber (app, "--pictures", "N", "of an animation", o.pictures)
      ->check (within (2, 2000));
  addNumber (app, "--rate", "HZ", "pictures per second", o.rate)
      ->check (inRange (1e-3, 120.0, "above 0, to 120"));
  addFlag (app, "--gif", "no longer made; says what joins the pictures", o.gif)
      ->group ("");
  addFlag (app, "--mp4", "also an MP4", o.mp4)->needs (animation);
  addFlag (app, "--quiet", "print nothing but errors", o.quiet);
}

} // namespace

void
addRenderOptions (CLI::App& app, RenderOptions& options)
{
  addInputOptions (app, options);
  addViewOptions (app, options);
  addStyleOptions (app, options);
  addAnimationOptions (app, options);
}

} // namespace pcl_msf::tool
