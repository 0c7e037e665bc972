// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/options.h"

#include "render/option_table.h"

#include <cstdio>
#include <string>

namespace pcl_msf::tool {

namespace {

CommandLine
makeCommandLine (RenderOptions& o)
{
  CommandLine line;
  line.summary = "Pictures of a scene flow in 3-D, made without a display.";
  line.syntax = {"pcl_msf_render RESULT [--sequence FOLDER] [options]",
                 "pcl_msf_render FOLDER [options]"};
  line.options = renderOptionTable (o);
  line.take_word = [&o] (const std::string& word) {
    if (!o.input.empty())
      throw UsageError ("'" + word + "': one input is enough; options have --");
    o.input = word;
  };
  return line;
}

void
check (const RenderOptions& o)
{
  std::string why;
  if (o.input.empty())
    throw UsageError ("give a folder of pcl_msf_scene_flow or one with frames");
  if (!o.style.isValid (&why))
    throw UsageError ("--" + why);
  if (o.frame.value_or (0) < 0 || o.reference.value_or (0) < 0 || o.window < 0)
    throw UsageError (
        "--frame, --reference, --window: " + std::to_string (o.frame.value_or (0)) +
        ", " + std::to_string (o.reference.value_or (0)) + ", " +
        std::to_string (o.window) + "; must not be negative");
  if (o.scene.arrow_step < 0 || !(o.scene.arrow_scale >= 0.0))
    throw UsageError ("--arrow-step, --arrow-scale: must not be negative");
  if (!(o.field_of_view > 1.0 && o.field_of_view < 170.0) || !(o.zoom > 0.0))
    throw UsageError ("--field-of-view must be 1 to 170, --zoom above 0");
  if (o.view == ViewPreset::User && !o.eye)
    throw UsageError ("--view user: needs --eye X,Y,Z");
  if (o.pictures < 2 || o.pictures > 2000 || !(o.rate > 0.0 && o.rate <= 120.0))
    throw UsageError ("--pictures must be 2 to 2000, --rate up to 120");
  if ((o.gif || o.mp4) && o.animation == Animation::None)
    throw UsageError ("--gif, --mp4: need --animation orbit or warp");
}

} // namespace

RenderOptions
parseRenderOptions (int argc, const char* const* argv)
{
  RenderOptions options;
  makeCommandLine (options).read (argc, argv);
  if (options.help)
    return options;
  if (options.output.empty())
    options.output = ".";
  if (options.kinds.empty() && options.animation == Animation::None)
    options.sheet = true;
  check (options);
  return options;
}

void
printRenderHelp ()
{
  RenderOptions defaults;
  makeCommandLine (defaults).printHelp();
  std::printf (
      "\nRESULT is a folder that pcl_msf_scene_flow wrote: scene_flow_R_K.pcd is "
      "read,\n"
      "bodies_R.png and visibility_R_K.png when they are there. Kinds that show the\n"
      "current frame need --sequence. FOLDER holds frames, as pcl_msf_scene_flow "
      "takes\n"
      "them; their scene flow is computed first, with the default parameters. Without\n"
      "a display an Xvfb is started.\n");
}

} // namespace pcl_msf::tool
