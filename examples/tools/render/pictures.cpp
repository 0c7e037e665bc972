// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/pictures.h"

#include "common/interruption.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/visualization/animation_files.h>
#include <pcl_msf/visualization/offscreen_renderer.h>
#include <pcl_msf/visualization/picture_sheet.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace pcl_msf::tool {

namespace {

using namespace visualization;
namespace fs = std::filesystem;

constexpr double kPi = 3.14159265358979323846;
constexpr int kSheetColumns = 4;

/** "orbit", "warp", or nothing. */
std::string
animationName (const RenderOptions& options)
{
  return options.animation == Animation::Orbit  ? "orbit"
         : options.animation == Animation::Warp ? "warp"
                                                : "";
}

/** One run: a renderer and the files it has written. */
class PictureRenderer {
public:
  PictureRenderer (const RenderInputs& inputs,
                   const RenderOptions& options,
                   OutputFolder& output)
  : inputs_ (inputs)
  , options_ (options)
  , output_ (output)
  , bounds_ (boundsOf (inputs.result.scene_flow.points))
  , style_ (options.style)
  {
    const cv::Size sensor = inputs.result.scene_flow.points.size();
    PictureStyle natural = style_;
    natural.size = sensor;
    if (!options.size_given && natural.isValid())
      style_ = natural;
  }

  void
  writeKinds ()
  {
    for (const PictureKind kind : options_.kinds)
      if (kind != PictureKind::Residual || options_.kinds.size() == 1 || hasColor())
        write (toString (kind) + ".png", draw (scene (kind), view (options_.azimuth)));
    if (options_.sheet)
      writeSheet();
  }

  void
  writeAnimation ()
  {
    const bool orbit = options_.animation == Animation::Orbit;
    const std::string name = animationName (options_);
    const PictureKind kind =
        options_.kinds.empty() ? PictureKind::AfterTints : options_.kinds.front();
    const Scene still = orbit ? scene (kind) : Scene();
    std::vector<std::string> pictures;
    for (int i = 0; i < options_.pictures; ++i) {
      const double turn = 2.0 * kPi * i / options_.pictures;
      const std::string file =
          cv::format ("%s/%s_%04d.png", name.c_str(), name.c_str(), i);
      write (file,
             orbit ? draw (still, orbitAt (turn))
                   : draw (warpScene (inputs_.result,
                                      inputs_.displacements,
                                      0.5 * (1.0 - std::cos (turn)) * lastFrame()),
                           view (options_.azimuth)));
      pictures.push_back (output_.locate (file));
    }
    encode (name, pictures);
  }

  const std::vector<std::string>&
  files () const
  {
    return files_;
  }

private:
  bool
  hasColor () const
  {
    return !inputs_.result.reference_color.empty() &&
           !inputs_.result.current_color.empty();
  }
  double
  lastFrame () const
  {
    return static_cast<double> (inputs_.displacements.size());
  }

  Scene
  scene (PictureKind kind) const
  {
    return kind == PictureKind::Trajectories
               ? trajectoryScene (inputs_.result, inputs_.displacements, options_.scene)
               : resultScene (kind, inputs_.result, options_.scene);
  }

  View
  view (double azimuth) const
  {
    const RenderOptions& o = options_;
    View result;
    switch (o.view) {
    case ViewPreset::Sensor:
      result = sensorView (inputs_.result.scene_flow.camera,
                           inputs_.result.scene_flow.points.size());
      break;
    case ViewPreset::Orbit:
      result = orbitView (
          bounds_, style_.size, azimuth, o.elevation, o.field_of_view, o.zoom);
      break;
    case ViewPreset::Top:
      result = topView (bounds_, style_.size, o.field_of_view, o.zoom);
      break;
    case ViewPreset::User:
      result = userView (*o.eye,
                         o.target.value_or (bounds_.center),
                         o.up,
                         style_.size,
                         o.field_of_view);
      break;
    }
    if (o.parallel)
      result = parallelView (result, (bounds_.center - result.position).norm());
    return result;
  }

  /** A whole turn, or there and back when it is less than one. */
  View
  orbitAt (double turn) const
  {
    const RenderOptions& o = options_;
    const double azimuth = o.sweep >= 360.0
                               ? o.azimuth + turn * 180.0 / kPi
                               : o.azimuth + 0.5 * o.sweep * std::sin (turn);
    View result =
        orbitView (bounds_, style_.size, azimuth, o.elevation, o.field_of_view, o.zoom);
    if (o.parallel)
      result = parallelView (result, (bounds_.center - result.position).norm());
    return result;
  }

  cv::Mat
  draw (const Scene& what, const View& from)
  {
    throwIfInterrupted();
    return renderer_.render (what, from, style_);
  }

  void
  write (const std::string& name, const cv::Mat& picture)
  {
    throwIfInterrupted();
    const fs::path staged = fs::path (output_.stage()) / name;
    io::makeFolder (staged.parent_path().string());
    io::writeImage (staged.string(), picture);
    add (name);
  }

  /** A file that is complete. */
  void
  add (const std::string& name)
  {
    output_.publish();
    files_.push_back ((fs::path (options_.output) / name).string());
  }

  void
  writeSheet ()
  {
    std::vector<PictureKind> kinds;
    if (!inputs_.result.current_points.empty())
      kinds = {PictureKind::BeforeTints, PictureKind::AfterTints};
    kinds.insert (kinds.end(), {PictureKind::Warped, PictureKind::Segments});
    if (!inputs_.result.scene_flow.segments.empty())
      kinds.push_back (PictureKind::Motions);
    kinds.push_back (PictureKind::Arrows);
    if (hasColor())
      kinds.push_back (PictureKind::Residual);
    else if (!inputs_.result.current_points.empty())
      kinds.push_back (PictureKind::DepthResidual);
    kinds.push_back (PictureKind::Occlusion);
    std::vector<cv::Mat> pictures;
    for (const PictureKind kind : kinds)
      pictures.push_back (draw (scene (kind), view (options_.azimuth)));
    write ("sheet.png", pictureSheet (pictures, kSheetColumns, style_.background));
  }

  void
  encode (const std::string& name, const std::vector<std::string>& pictures)
  {
    const std::string base = (fs::path (output_.stage()) / name).string();
    if (options_.mp4) {
      writeMp4 (base + ".mp4", pictures, options_.rate, interrupted);
      add (name + ".mp4");
    }
  }

  const RenderInputs& inputs_;
  const RenderOptions& options_;
  OutputFolder& output_;
  SceneBounds bounds_;
  PictureStyle style_;
  OffscreenRenderer renderer_;
  std::vector<std::string> files_;
};

} // namespace

std::string
resultOf (const RenderOptions& options)
{
  std::error_code error;
  std::string result = fs::canonical (options.input, error).string();
  const OutputManifest files (options.input, "pcl_msf_scene_flow");
  const auto first = files.entries().lower_bound ("scene_flow_");
  if (first != files.entries().end()) // another run has other points
    result += " " + std::to_string (first->second.hash);
  return result;
}

void
prepareOutput (const RenderOptions& options, OutputFolder& output)
{
  const std::string animation = animationName (options);
  const auto moves = [animation] (const std::string& name) {
    return !animation.empty() &&
           (name.rfind (animation + "/", 0) == 0 || name == animation + ".gif" ||
            name == animation + ".mp4");
  };
  output.keep ([&] (const std::string& name, const std::string& group) {
    return group == output.group() && !moves (name);
  });
  InputFiles inputs;
  for (const std::string& recording : {options.input, options.sequence})
    if (resultPairs (recording).empty())
      inputs.add (recording, options.output);
  output.check (inputs, [&] (const std::string& name) {
    bool drawn = moves (name) || (options.sheet && name == "sheet.png");
    for (const PictureKind kind : options.kinds)
      drawn = drawn || name == toString (kind) + ".png";
    return drawn;
  });
}

std::vector<std::string>
writeRenders (const RenderInputs& inputs,
              const RenderOptions& options,
              OutputFolder& output)
{
  PictureRenderer renderer (inputs, options, output);
  renderer.writeKinds();
  if (options.animation != Animation::None)
    renderer.writeAnimation();
  output.finish();
  return renderer.files();
}

} // namespace pcl_msf::tool
