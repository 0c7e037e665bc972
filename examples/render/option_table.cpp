// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/option_table.h"

#include "common/option_values.h"
#include "render/inputs.h"

#include <optional>
#include <utility>

namespace pcl_msf::tool {

namespace {

using visualization::PictureKind;

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

bool
addKind (const std::string& text, RenderOptions& options)
{
  const bool sheet = text == "sheet" || text == "all";
  const std::size_t before = options.kinds.size();
  options.sheet = options.sheet || sheet;
  for (const auto& [name, kind] : visualization::pictureKinds())
    if (name == text || text == "all")
      options.kinds.push_back (kind);
  return sheet || options.kinds.size() > before;
}

std::string
kindNames ()
{
  std::string names;
  for (const auto& kind : visualization::pictureKinds())
    names += kind.first + ", ";
  return names + "sheet (side by side) or all; may be given again [sheet]";
}

std::vector<Option>
inputOptions (RenderOptions& o)
{
  return {
      {"--sequence",
       "FOLDER",
       "frames of a result folder: color_K, depth_K, camera.txt, "
       "or a data set's",
       text (o.sequence)},
      {"--reference",
       "R",
       "the frame whose points are followed [the first of a result, else 0]",
       [&o] (const std::string& word) { return parse (word, o.reference.emplace()); }},
      {"--frame",
       "K",
       "the current frame [the one after the reference]",
       [&o] (const std::string& word) { return parse (word, o.frame.emplace()); }},
      {"--window",
       "K",
       "last frame of trajectories and of the warp [--frame]",
       number (o.window)},
      {"--kind",
       "KIND",
       kindNames(),
       [&o] (const std::string& word) { return addKind (word, o); }},
      {"--output", "DIR", "folder for KIND.png and so on [.]", text (o.output)}};
}

std::vector<Option>
viewOptions (RenderOptions& o)
{
  return {
      {"--view",
       "NAME",
       "sensor, orbit, top, or user with --eye and --target [sensor]",
       choice (o.view,
               {{"sensor", ViewPreset::Sensor},
                {"orbit", ViewPreset::Orbit},
                {"top", ViewPreset::Top},
                {"user", ViewPreset::User}})},
      {"--azimuth", "DEG", "orbit: to the right [25]", number (o.azimuth)},
      {"--elevation", "DEG", "orbit: upwards, -89 to 89 [20]", number (o.elevation)},
      {"--zoom", "FACTOR", "orbit, top: nearer when above 1 [1]", number (o.zoom)},
      {"--eye",
       "X,Y,Z",
       "user: metres, sensor's frame (x right, y down, z forward)",
       [&o] (const std::string& word) { return parsePoint (word, o.eye); }},
      {"--target",
       "X,Y,Z",
       "user: the point looked at [the scene's centre]",
       [&o] (const std::string& word) { return parsePoint (word, o.target); }},
      {"--up",
       "X,Y,Z",
       "user [0,-1,0]",
       [&o] (const std::string& word) {
         std::optional<Eigen::Vector3d> up;
         if (parsePoint (word, up))
           o.up = *up;
         return up.has_value();
       }},
      {"--field-of-view",
       "DEG",
       "orbit, top, user: along the larger side [45]",
       number (o.field_of_view)},
      {"--parallel",
       "0|1",
       "parallel projection, with a length in metres [0]",
       boolean (o.parallel)}};
}

std::vector<Option>
styleOptions (RenderOptions& o)
{
  return {
      {"--size",
       "WxH",
       "pixels, up to 3840x2160 [the sensor's size]",
       [&o] (const std::string& word) { return parseSize (word, o); }},
      {"--supersampling",
       "N",
       "drawn N times larger, 1 to 8 [2]",
       number (o.style.supersampling)},
      {"--point-size",
       "PX",
       "0 = as large as the gaps between points [0]",
       number (o.style.point_size)},
      {"--background",
       "COLOR",
       "white, black or R,G,B [white]",
       [&o] (const std::string& word) {
         return parseBackground (word, o.style.background);
       }},
      {"--axes", "0|1", "directions of the sensor's frame [1]", boolean (o.style.axes)},
      {"--legend", "0|1", "legend and colour scale [1]", boolean (o.style.legend)},
      {"--title", "0|1", "[1]", boolean (o.style.title)},
      {"--arrow-step",
       "PX",
       "pixels between arrows or trajectories, 0 = as fit [0]",
       number (o.scene.arrow_step)},
      {"--arrow-scale",
       "FACTOR",
       "arrows are so many times the displacement, 0 = as can be seen [0]",
       number (o.scene.arrow_scale)},
      {"--maximum",
       "VALUE",
       "end of the colour scale, 0 = 99th percentile [0]",
       number (o.scene.maximum)}};
}

std::vector<Option>
animationOptions (RenderOptions& o)
{
  return {
      {"--animation",
       "NAME",
       "orbit (around the first --kind) or warp (reference to "
       "current and back) as PNG sequence",
       choice (o.animation, {{"orbit", Animation::Orbit}, {"warp", Animation::Warp}})},
      {"--sweep",
       "DEG",
       "orbit: there and back over so much, 360 = a whole turn [60]",
       number (o.sweep)},
      {"--pictures", "N", "of an animation, 2 to 2000 [48]", number (o.pictures)},
      {"--rate", "HZ", "pictures per second [24]", number (o.rate)},
      {"--gif", "", "also an animated GIF, by ffmpeg or ImageMagick", flag (o.gif)},
      {"--mp4", "", "also an MP4, by ffmpeg or OpenCV", flag (o.mp4)},
      {"--quiet", "", "print nothing but errors", flag (o.quiet)},
      {"--help", "", "print this", flag (o.help)}};
}

} // namespace

std::vector<Option>
renderOptionTable (RenderOptions& options)
{
  std::vector<Option> table = inputOptions (options);
  for (Option& option : readingOptions (options.reading))
    table.push_back (std::move (option));
  for (auto make : {viewOptions, styleOptions, animationOptions})
    for (Option& option : make (options))
      table.push_back (std::move (option));
  return table;
}

} // namespace pcl_msf::tool
