// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Renders an RGB-D sequence with exact truth into a folder.
#include "common/camera_effects.h"
#include "common/command_line.h"
#include "common/interruption.h"
#include "common/output_folder.h"
#include "common/stop_watch.h"
#include "common/tool_main.h"
#include "core/base/number_text.h"
#include <CLI/App.hpp>
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/body_clouds.h>
#include <pcl_msf/synthetic/sequence_writer.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <regex>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_synthesize";
constexpr const char* kFolder = "FOLDER"; // the option that names the output

/** What readers of TUM's layout assume of 640x480 images, unless told. */
constexpr PinholeCamera kTumCamera{525.0, 525.0, 319.5, 239.5};

struct SynthesizeOptions {
  std::string folder;
  SequenceOptions sequence;
  SequenceWriterOptions writing;
  std::optional<BodyKind> body; ///< clouds of it instead of a sequence
  BodyOptions drawing;
};

constexpr const char* kSummary =
    "Renders an RGB-D sequence with exact scene flow, optical flow,\n"
    "visibility, labels and poses; or draws two clouds of an articulated body with\n"
    "the truth of every point, parts and joints (--body).";

void
addSceneOptions (CLI::App& app, SequenceOptions& s)
{
  Words<SceneKind> scenes;
  for (const SceneKind scene : allScenes())
    scenes.emplace_back (toString (scene), scene);
  beginGroup (app, "What to render");
  addWord<SceneKind> (app, "--scene", "what moves", s.scene, scenes);
  addWord<MotionSize> (app,
                       "--motion",
                       "4 or 22 px a frame",
                       s.motion,
                       {{"easy", MotionSize::Easy}, {"large", MotionSize::Large}});
  addNumber (app,
             "--motion-pixels",
             "PX",
             "average motion a frame at 640 px width, 0 = as --motion says",
             s.motion_pixels);
  addWord<Sensor> (app,
                   "--sensor",
                   "whose noise; white is a kinect's without correlation",
                   s.sensor,
                   sensorWords());
  addNumber (app, "--width", "PX", "of an image", s.width);
  addNumber (app, "--height", "PX", "of an image", s.height);
  addNumber (app, "--frames", "N", "of the sequence", s.frames);
  addNumber (app, "--seed", "N", "places, colours, motions, noise", s.seed);
  addNumber (app, "--noise-seed", "N", "of the noise alone [--seed]", s.noise_seed);
  addNumber (app, "--samples", "N", "colour rays per pixel and axis", s.supersampling);
  addSwitch (app, "--blur", "motion blur", s.motion_blur);
  addNumber (app, "--threads", "N", "0 = all; no influence on the result", s.threads);
}

void
addWritingOptions (CLI::App& app, SequenceWriterOptions& w)
{
  beginGroup (app, "How to write it");
  addWord<SequenceLayout> (app,
                           "--layout",
                           "names and folders",
                           w.layout,
                           {{"cases", SequenceLayout::Cases},
                            {"tum", SequenceLayout::Tum},
                            {"sintel", SequenceLayout::Sintel}});
  addWord<DepthFormat> (app,
                        "--depth",
                        "of cases; auto is dpt without a sensor",
                        w.depth_format,
                        {{"auto", DepthFormat::Automatic},
                         {"dpt", DepthFormat::Float},
                         {"png", DepthFormat::Png16}});
  addNumber (app, "--depth-scale", "S", "16-bit depth units per metre", w.depth_scale);
}

void
addBodyOptions (CLI::App& app, SynthesizeOptions& o)
{
  Words<std::optional<BodyKind>> bodies{{"none", std::nullopt}};
  for (const BodyKind body : allBodies())
    bodies.emplace_back (toString (body), body);
  beginGroup (app, "Clouds of a body, without a grid (with --seed)");
  addWord<std::optional<BodyKind>> (app, "--body", "which", o.body, bodies);
  BodyOptions& b = o.drawing;
  addNumber (app, "--points", "N", "of each cloud", b.points);
  addNumber (app, "--angle", "DEG", "that a joint turns by, at the most", b.angle);
  addNumber (app, "--noise", "M", "metres a coordinate, on both", b.noise);
  addNumber (
      app, "--outliers", "SHARE", "of the points, besides in the target", b.outliers);
  addNumber (app, "--cut", "SHARE", "of the target, cut off", b.cut);
}

/** What is wrong with the library's options, in the words of the command line. */
std::string
asOption (const std::string& problem)
{
  const std::size_t end = std::min (problem.find_first_of (" :"), problem.size());
  std::string name = problem.substr (0, end);
  if (name == "no") // lens distortion
    return "--lens: " + problem;
  if (name == "supersampling")
    name = "samples";
  if (name.rfind ("depth_shift", 0) == 0) // x or y
    name = "depth-shift";
  std::replace (name.begin(), name.end(), '_', '-');
  return "--" + name + problem.substr (end);
}

/** What readers of the layout assume is rendered where it can be. */
void
chooseCamera (SynthesizeOptions& options)
{
  SequenceOptions& sequence = options.sequence;
  if (options.writing.layout == SequenceLayout::Tum && sequence.width == 640 &&
      sequence.height == 480)
    sequence.camera = kTumCamera;
}

void
checkOptions (const SynthesizeOptions& options)
{
  std::string why;
  if (!(options.body ? options.drawing.isValid (&why)
                     : options.sequence.isValid (&why)))
    throw UsageError (asOption (why));
  const double scale = options.writing.depth_scale;
  if (!(scale > 0.0))
    throw UsageError ("--depth-scale: " + generalText (scale) +
                      ", must be > 0; give units per metre, for example 5000");
}

void
declareOptions (CLI::App& app, SynthesizeOptions& options)
{
  addText (app, kFolder, "PATH", "for the sequence", options.folder)->required();
  addSceneOptions (app, options.sequence);
  addCameraEffects (app, options.sequence.effects);
  addWritingOptions (app, options.writing);
  addBodyOptions (app, options);
  app.final_callback ([&options] {
    chooseCamera (options);
    checkOptions (options);
  });
}

/** Version 0.1.0 spelled options "-motion_pixels"; both ways are understood. */
std::vector<std::string>
withTwoDashes (int argc, const char* const* argv)
{
  std::vector<std::string> words (argv, argv + argc);
  for (std::string& word : words)
    if (word.size() > 2 && word[0] == '-' &&
        std::isalpha (static_cast<unsigned char> (word[1])) != 0) {
      word.insert (0, "-");
      for (std::size_t i = 0; i < word.size() && word[i] != '='; ++i)
        word[i] = word[i] == '_' ? '-' : word[i];
    }
  return words;
}

/** What a later run replaces; scenes of a Sintel folder stand beside each other. */
std::string
groupOf (const SynthesizeOptions& options)
{
  if (options.body)
    return "body";
  switch (options.writing.layout) {
  case SequenceLayout::Cases:
    return "cases";
  case SequenceLayout::Tum:
    return "tum";
  default:
    return std::string ("sintel ") + toString (options.sequence.scene);
  }
}

/** Files that would be read together with those of this sequence. */
std::string
patternOf (const SynthesizeOptions& options)
{
  if (options.body)
    return "(source|target|truth)\\.ply|(labels|poses|joints)\\.txt";
  const std::string scene = toString (options.sequence.scene);
  switch (options.writing.layout) {
  case SequenceLayout::Cases:
    return "(color|depth|cloud)_[0-9]+\\.[a-z]+|camera\\.txt|gt/.*";
  case SequenceLayout::Tum:
    return "(rgb|depth)/.*|(rgb|depth|groundtruth|associations|camera)\\.txt";
  default:
    return "(clean|final|depth|camdata_left|flow|occlusions|invalid)/(" + scene +
           "/.*)?";
  }
}

void
prepare (const SynthesizeOptions& options, OutputFolder& output)
{
  const std::string own = groupOf (options);
  output.keep ([&own] (const std::string&, const std::string& group) {
    return group != own && group.rfind ("sintel", 0) == 0 &&
           own.rfind ("sintel", 0) == 0;
  });
  const std::regex pattern (patternOf (options));
  output.check ({}, [&pattern] (const std::string& name) {
    return std::regex_match (name, pattern);
  });
}

void
drawBody (const SynthesizeOptions& options)
{
  BodyOptions drawing = options.drawing;
  drawing.body = *options.body;
  drawing.seed = options.sequence.seed;
  const BodyClouds clouds = synthesizeBody (drawing);
  OutputFolder output (options.folder, kProgram, groupOf (options), kFolder);
  prepare (options, output);
  writeBody (clouds, output.stage());
  throwIfInterrupted();
  output.finish();
  std::printf ("%zu and %zu points of a body, %s, written to %s\n",
               clouds.source.size(),
               clouds.target.size(),
               toString (drawing.body),
               options.folder.c_str());
}

void
write (const SyntheticSequence& sequence,
       const std::string& folder,
       const SequenceWriterOptions& options)
{
  try {
    writeSequence (sequence, folder, options);
  }
  catch (const InvalidInput& problem) {
    throw UsageError (asOption (problem.what()));
  }
}

/** TUM's layout holds no camera: says what other tools must be told. Readers know
 * sensors by the folder's name. */
void
printCamera (const SynthesizeOptions& options, const PinholeCamera& used)
{
  static const std::regex sensor ("(freiburg|fr)[123]");
  const std::filesystem::path folder = std::filesystem::canonical (options.folder);
  if (used.fx == kTumCamera.fx &&
      !std::regex_search (folder.filename().string(), sensor))
    return;
  std::printf ("this layout holds no camera; give the other tools --camera "
               "%s,%s,%s,%s\n",
               generalText (used.fx).c_str(),
               generalText (used.fy).c_str(),
               generalText (used.cx).c_str(),
               generalText (used.cy).c_str());
}

int
run (const SynthesizeOptions& given)
{
  SynthesizeOptions options = given;
  if (options.body) {
    drawBody (options);
    return 0;
  }
  { // refused before the work
    OutputFolder output (options.folder, kProgram, groupOf (options), kFolder);
    prepare (options, output);
  }
  options.sequence.successive_truth = options.writing.layout == SequenceLayout::Sintel;
  StopWatch watch;
  const SyntheticSequence sequence = synthesize (options.sequence);
  const double seconds = watch.lap();
  OutputFolder output (options.folder, kProgram, groupOf (options), kFolder);
  prepare (options, output);
  write (sequence, output.stage(), options.writing);
  throwIfInterrupted();
  output.finish();
  std::printf ("%d frames of %s in %.2f s, written to %s\n",
               options.sequence.frames,
               toString (options.sequence.scene),
               seconds,
               options.folder.c_str());
  if (options.writing.layout == SequenceLayout::Tum)
    printCamera (options, sequence.camera);
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  const std::vector<std::string> words = withTwoDashes (argc, argv);
  std::vector<const char*> pointers;
  for (const std::string& word : words)
    pointers.push_back (word.c_str());
  return toolMain<SynthesizeOptions> (
      {kProgram, kSummary, declareOptions, run}, argc, pointers.data());
}
