// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Renders an RGB-D sequence with exact truth into a folder.
#include "common/command_line.h"
#include "common/default_help.h"
#include "common/interruption.h"
#include "common/output_folder.h"
#include "common/stop_watch.h"
#include "common/tool_main.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_writer.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <cctype>
#include <cstdio>
#include <regex>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_synthesize";

struct SynthesizeOptions {
  std::string folder;
  SequenceOptions sequence;
  SequenceWriterOptions writing;
  bool help{false};
};

std::vector<Option>
optionTable (SynthesizeOptions& o)
{
  SequenceOptions& s = o.sequence;
  std::vector<std::pair<std::string, Scene>> scenes;
  for (const Scene scene : allScenes())
    scenes.emplace_back (toString (scene), scene);
  return {
      oneOf<Scene> ("--scene", s.scene, scenes),
      oneOf<MotionSize> ("--motion",
                         s.motion,
                         {{"easy", MotionSize::Easy}, {"large", MotionSize::Large}},
                         ": 4 or 22 px a frame"),
      numeric ("--motion-pixels",
               "PX",
               "average motion a frame at 640 px width, 0 = as --motion says",
               s.motion_pixels),
      oneOf<Sensor> (
          "--sensor", s.sensor, {{"none", Sensor::Ideal}, {"kinect", Sensor::Kinect}}),
      numeric ("--width", "PX", "", s.width),
      numeric ("--height", "PX", "", s.height),
      numeric ("--frames", "N", "", s.frames),
      numeric ("--seed", "N", "places, colours, motions, noise", s.seed),
      numeric ("--samples", "N", "colour rays per pixel and axis", s.supersampling),
      switchable ("--blur", "motion blur", s.motion_blur),
      numeric ("--threads", "N", "0 = all; no influence on the result", s.threads),
      oneOf<SequenceLayout> ("--layout",
                             o.writing.layout,
                             {{"cases", SequenceLayout::Cases},
                              {"tum", SequenceLayout::Tum},
                              {"sintel", SequenceLayout::Sintel}}),
      oneOf<DepthFormat> ("--depth",
                          o.writing.depth_format,
                          {{"auto", DepthFormat::Automatic},
                           {"dpt", DepthFormat::Float},
                           {"png", DepthFormat::Png16}},
                          " of cases; auto is dpt without a sensor"),
      numeric (
          "--depth-scale", "S", "16-bit depth units per metre", o.writing.depth_scale),
      {"--help", "", "print this", flag (o.help)}};
}

CommandLine
makeCommandLine (SynthesizeOptions& options)
{
  CommandLine line;
  line.summary = "Renders an RGB-D sequence with exact scene flow, optical flow,\n"
                 "visibility, labels and poses.";
  line.syntax = {"pcl_msf_synthesize FOLDER [options]"};
  line.options = optionTable (options);
  line.take_word = [&options] (const std::string& word) {
    if (!options.folder.empty() || word.empty())
      throw UsageError ("'" + word + "': one folder is enough; options have --");
    options.folder = word;
  };
  return line;
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

int
run (SynthesizeOptions options)
{
  if (options.folder.empty())
    throw UsageError ("FOLDER: missing; give one for the sequence");
  { // refused before the work
    OutputFolder output (options.folder, kProgram, groupOf (options));
    prepare (options, output);
  }
  options.sequence.successive_truth = options.writing.layout == SequenceLayout::Sintel;
  StopWatch watch;
  const SyntheticSequence sequence = synthesize (options.sequence);
  const double seconds = watch.lap();
  noteSignals();
  OutputFolder output (options.folder, kProgram, groupOf (options));
  prepare (options, output);
  writeSequence (sequence, output.stage(), options.writing);
  throwIfInterrupted();
  output.finish();
  std::printf ("%d frames of %s in %.2f s, written to %s\n",
               options.sequence.frames,
               toString (options.sequence.scene),
               seconds,
               options.folder.c_str());
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return runTool (kProgram, [&] {
    SynthesizeOptions options;
    const CommandLine line = makeCommandLine (options);
    std::vector<const char*> words;
    const std::vector<std::string> given = withTwoDashes (argc, argv);
    for (const std::string& word : given)
      words.push_back (word.c_str());
    line.read (argc, words.data());
    if (options.help || argc < 2) {
      line.printHelp();
      return options.help ? 0 : 1;
    }
    return run (options);
  });
}
