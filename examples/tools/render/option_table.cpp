// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/option_table.h"

#include "common/default_help.h"
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
      numeric ("--window",
               "K",
               "last frame of trajectories and of the warp, 0 = --frame",
               o.window),
      {"--kind",
       "KIND",
       kindNames(),
       [&o] (const std::string& word) { return addKind (word, o); }},
      {"--output", "DIR", "folder for KIND.png and so on [.]", text (o.output)}};
}

std::vector<Option>
viewOptions (RenderOptions& o)
{
  return {{"--view",
           "NAME",
           "sensor, orbit, top, or user with --eye and --target [sensor]",
           choice (o.view,
                   {{"sensor", ViewPreset::Sensor},
                    {"orbit", ViewPreset::Orbit},
                    {"top", ViewPreset::Top},
                    {"user", ViewPreset::User}})},
          numeric ("--azimuth", "DEG", "orbit: to the right", o.azimuth),
          numeric ("--elevation", "DEG", "orbit: upwards, -89 to 89", o.elevation),
          numeric ("--zoom", "FACTOR", "orbit, top: nearer when above 1", o.zoom),
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
          numeric ("--field-of-view",
                   "DEG",
                   "orbit, top, user: along the larger side",
                   o.field_of_view),
          switchable ("--parallel",
                      "parallel projection, with a length in metres",
                      o.parallel)};
}

std::vector<Option>
styleOptions (RenderOptions& o)
{
  return {{"--size",
           "WxH",
           "pixels, up to 3840x2160 [the sensor's size]",
           [&o] (const std::string& word) { return parseSize (word, o); }},
          numeric ("--supersampling",
                   "N",
                   "drawn N times larger, 1 to 8",
                   o.style.supersampling),
          numeric ("--point-size",
                   "PX",
                   "0 = as large as the gaps between points",
                   o.style.point_size),
          {"--background",
           "COLOR",
           "white, black or R,G,B [white]",
           [&o] (const std::string& word) {
             return parseBackground (word, o.style.background);
           }},
          switchable ("--axes", "directions of the sensor's frame", o.style.axes),
          switchable ("--legend", "legend and colour scale", o.style.legend),
          switchable ("--title", "", o.style.title),
          numeric ("--arrow-step",
                   "PX",
                   "pixels between arrows or trajectories, 0 = as fit",
                   o.scene.arrow_step),
          numeric ("--arrow-scale",
                   "FACTOR",
                   "arrows are so many times the displacement, 0 = as can be seen",
                   o.scene.arrow_scale),
          numeric ("--maximum",
                   "VALUE",
                   "end of the colour scale, 0 = 99th percentile",
                   o.scene.maximum)};
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
      numeric ("--sweep",
               "DEG",
               "orbit: there and back over so much, 360 = a whole turn",
               o.sweep),
      numeric ("--pictures", "N", "of an animation, 2 to 2000", o.pictures),
      numeric ("--rate", "HZ", "pictures per second", o.rate),
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
