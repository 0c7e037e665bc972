// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// End-point error of an optical flow, as pcl_msf_evaluate counts it.
#include "common/command_line.h"
#include "common/input_files.h"
#include "common/option_values.h"
#include "common/tool_main.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/io/figures.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <cstdio>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_flow_error";

void
printErrors (const char* name,
             const cv::Mat& flow,
             const cv::Mat& truth,
             const cv::Mat& mask)
{
  const evaluation::FlowErrors errors = evaluation::flowErrors (flow, truth, mask);
  if (errors.points == 0)
    std::printf ("%-15s no pixel to compare\n", name);
  else
    std::printf ("%-15s mean %7.3f px, median %7.3f px, over 3 px and 5 %% %5.2f %%, "
                 "known %6.2f %%\n",
                 name,
                 errors.epe,
                 errors.median,
                 100.0 * errors.outliers,
                 100.0 * errors.coverage);
}

int
run (const std::vector<std::string>& files)
{
  InputFiles inputs;
  for (std::size_t i = 0; i < files.size() && i < 3; ++i)
    inputs.add (files[i]);
  if (files.size() == 4)
    requireNoInput ("ERROR.png", files[3], inputs);
  const cv::Mat flow = io::readFlow (files[0]);
  const cv::Mat truth = io::readFlow (files[1]);
  if (flow.size() != truth.size())
    throw InvalidInput (files[0] + " and " + files[1] + " differ in size");
  printErrors (
      "all points", flow, truth, cv::Mat (truth.size(), CV_8UC1, cv::Scalar (255)));
  if (files.size() > 2) {
    const cv::Mat visible = io::readMask (files[2]);
    if (visible.size() != truth.size())
      throw InvalidInput (files[2] + ": no image of the flow's size");
    printErrors ("visible points", flow, truth, visible > 0);
  }
  if (files.size() == 4)
    io::writeImage (
        files[3],
        io::scalarPicture (evaluation::endPointErrors (flow, truth), 0.0, "px"));
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return runTool (kProgram, [&] {
    std::vector<std::string> files;
    bool help = false;
    CommandLine line;
    line.summary =
        "Prints the end-point error of an optical flow against the truth; an "
        "unknown flow\ncounts as zero motion. ERROR.png becomes a picture of "
        "it.";
    line.syntax = {"pcl_msf_flow_error FLOW.flo TRUTH.flo [VISIBLE.png [ERROR.png]]"};
    line.options = {{"--help", "", "print this", flag (help)}};
    line.take_word = [&files] (const std::string& word) { files.push_back (word); };
    line.read (argc, argv);
    if (help || argc < 2) {
      line.printHelp();
      return help ? 0 : 1;
    }
    if (files.size() < 2 || files.size() > 4)
      throw UsageError ("give FLOW.flo TRUTH.flo [VISIBLE.png [ERROR.png]]");
    return run (files);
  });
}
