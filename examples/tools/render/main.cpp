// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Pictures of a scene flow in 3-D: result folders or frames in, PNG files out.
#include "common/input_files.h"
#include "common/output_folder.h"
#include "common/tool_main.h"
#include "render/cloud_pictures.h"
#include "render/inputs.h"
#include "render/options.h"
#include "render/pictures.h"

#include <cstdio>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_render";
constexpr int kNotConverged = 3; // exit status; everything was written

int
run (const RenderOptions& options)
{
  if (isCloudResult (options))
    return renderClouds (options);
  for (const std::string& recording : {options.input, options.sequence})
    if (resultPairs (recording).empty())
      requireOutside ("--output", options.output, recording);
  // Before the work: it may be the wrong one.
  OutputFolder output (options.output, kProgram, resultOf (options));
  prepareOutput (options, output);
  const RenderInputs inputs = loadRenderInputs (options);
  for (const std::string& file : writeRenders (inputs, options, output))
    if (!options.quiet)
      std::printf ("%s\n", file.c_str());
  return inputs.converged ? 0 : kNotConverged;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<RenderOptions> (
      {kProgram, kSummary, declareOptions, run}, argc, argv);
}
