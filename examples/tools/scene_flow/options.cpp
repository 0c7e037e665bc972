// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "options.h"

#include <pcl/console/print.h>

#include "core/base/number_text.h"
#include "option_table.h"

namespace pcl_msf::tool {

namespace {

void
checkCount (const char* name, std::size_t count, std::size_t wanted)
{
  const std::string given =
      std::string (name) + ": given " + std::to_string (count) + " times; ";
  if (count < 2)
    throw UsageError (given + "give it twice or more, in the order of time");
  if (count != wanted)
    throw UsageError (given + "give it once a frame, as --depth");
}

void
checkFiles (const Options& options)
{
  const bool images = !options.color.empty() || !options.depth.empty();
  if (images && !options.cloud.empty())
    throw UsageError (
        "--cloud: not together with --color or --depth; give clouds or images");
  if (options.cloud.empty()) {
    checkCount ("--depth", options.depth.size(), options.depth.size());
    if (!options.color.empty())
      checkCount ("--color", options.color.size(), options.depth.size());
    if (!options.camera)
      throw UsageError ("--camera: missing; give FX,FY,CX,CY in pixels");
  }
  else
    checkCount ("--cloud", options.cloud.size(), options.cloud.size());
  if (options.output.empty())
    throw UsageError ("--output: missing; give a folder for the results");
}

void
checkInputs (const Options& options)
{
  const bool files =
      !options.color.empty() || !options.depth.empty() || !options.cloud.empty();
  if (options.sequence.empty())
    checkFiles (options);
  else if (files)
    throw UsageError (
        "'" + options.sequence +
        "': not together with --color, --depth or --cloud; give the folder or "
        "files");
  if (options.window < 0 || options.window == 1)
    throw UsageError ("--window: " + std::to_string (options.window) +
                      ", must be 0 or at least 2");
  if (options.reference < 0)
    throw UsageError ("--reference: " + std::to_string (options.reference) +
                      ", must be >= 0");
  if (options.track && (options.reference > 0 || !options.labels.empty()))
    throw UsageError ("--track: not together with --reference or --labels; leave these "
                      "away");
  if (options.track && options.window > 16)
    throw UsageError ("--window: " + std::to_string (options.window) +
                      ", must be at most 16 with --track");
}

template <typename Parameters>
void
checkParameters (const Parameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    return;
  for (char& c : why)
    c = c == '_' ? '-' : c;
  throw UsageError ("--" + why);
}

} // namespace

Options
parseOptions (int argc, const char* const* argv)
{
  Options options;
  const auto take_word = [&options] (const std::string& word) {
    if (!options.sequence.empty() || word.empty())
      throw UsageError ("'" + word + "': not an option; --help lists them");
    options.sequence = word;
  };
  readCommandLine (argc, argv, makeOptionTable (options), take_word);
  if (options.help)
    return options;
  checkInputs (options);
  checkParameters (options.frame);
  checkParameters (options.segmentation);
  checkParameters (options.energy);
  checkParameters (options.solver);
  checkParameters (options.multiframe);
  if (options.rigid)
    options.segmentation.method = SegmentationMethod::Single;
  if (options.flow_maximum < 0.0)
    throw UsageError ("--flow-max: " + generalText (options.flow_maximum) +
                      ", must be >= 0, in pixels");
  return options;
}

void
printHelp (const char* program)
{
  using namespace pcl::console;
  print_info ("Piecewise-rigid scene flow between RGB-D frames.\n\n");
  print_info ("Syntax: %s --color C0.png --depth D0.png --color C1.png --depth D1.png "
              "--camera FX,FY,CX,CY --depth-scale S --output DIR\n",
              program);
  print_info ("    or: %s --cloud A.pcd --cloud B.pcd [--camera FX,FY,CX,CY] --output "
              "DIR\n",
              program);
  print_info ("    or: %s FOLDER [--window N] [--track] [--output DIR]\n", program);
  print_info ("Give --color, --depth or --cloud once a frame, in the order of time. "
              "FOLDER is a recording:\ncolor_K.png, depth_K.png and camera.txt, or one "
              "of the data sets' layouts (TUM RGB-D, ...).\n");
  print_info ("Exit status: 0 = written and converged, 3 = written but not converged "
              "(stderr says why), else an error.\n");
  Options defaults;
  printOptions (makeOptionTable (defaults));
}

} // namespace pcl_msf::tool
