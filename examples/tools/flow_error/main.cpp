// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// End-point error of an optical flow, as pcl_msf_evaluate counts it.
#include "common/command_line.h"
#include "common/input_files.h"
#include "common/tool_main.h"
#include <CLI/App.hpp>
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

/** \return has there been a pixel to compare? */
bool
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
  return errors.points > 0;
}

std::string
sizeText (const cv::Mat& image)
{
  return std::to_string (image.cols) + "x" + std::to_string (image.rows);
}

void
requireSize (const std::string& path,
             const cv::Mat& image,
             const std::string& truth_path,
             const cv::Mat& truth)
{
  if (image.size() != truth.size())
    throw InvalidInput (path + " is " + sizeText (image) + ", " + truth_path + " " +
                        sizeText (truth) + "; give files of one size");
}

/** 255 where the file is not 0. */
cv::Mat
readVisible (const std::string& path)
{
  const cv::Mat mask = io::readImage (path);
  if (mask.type() != CV_8UC1)
    throw InvalidInput (path + ": mask: " + std::to_string (8 * mask.elemSize1()) +
                        " bit in " + std::to_string (mask.channels()) +
                        " channel(s), not 8 bit in one; give a grey image, 0 = hidden");
  return mask > 0;
}

struct FlowErrorOptions {
  std::string flow;
  std::string truth;
  std::string visible; ///< may be empty
  std::string error;   ///< may be empty
};

void
declareOptions (CLI::App& app, FlowErrorOptions& o)
{
  addText (app, "FLOW", "FILE.flo", "an estimate", o.flow)->required();
  addText (app, "TRUTH", "FILE.flo", "what it should be", o.truth)->required();
  addText (app, "VISIBLE", "FILE.png", "a mask, for a second line", o.visible);
  addText (app, "ERROR", "FILE.png", "becomes a picture of the error", o.error);
}

int
run (const FlowErrorOptions& o)
{
  InputFiles inputs;
  for (const std::string& file : {o.flow, o.truth, o.visible})
    inputs.add (file);
  if (!o.error.empty())
    requireNoInput ("ERROR.png", o.error, inputs);
  const cv::Mat flow = io::readFlow (o.flow);
  const cv::Mat truth = io::readFlow (o.truth);
  requireSize (o.flow, flow, o.truth, truth);
  cv::Mat visible;
  if (!o.visible.empty()) {
    visible = readVisible (o.visible);
    requireSize (o.visible, visible, o.truth, truth);
  }
  bool compared = printErrors (
      "all points", flow, truth, cv::Mat (truth.size(), CV_8UC1, cv::Scalar (255)));
  if (!visible.empty())
    compared = printErrors ("visible points", flow, truth, visible) && compared;
  if (!o.error.empty())
    io::writeImage (
        o.error,
        io::scalarPicture (evaluation::endPointErrors (flow, truth), 0.0, "px"));
  if (!compared)
    throw InvalidInput (o.truth + ": no pixel to compare: the flow is unknown there" +
                        (visible.empty() ? "" : ", or " + o.visible + " hides it") +
                        "; give another truth or mask");
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<FlowErrorOptions> (
      {kProgram,
       "Prints the end-point error of an optical flow against the truth; an unknown "
       "flow\ncounts as zero motion. Exit status: not 0 when there is no pixel to "
       "compare.",
       declareOptions,
       run},
      argc,
      argv);
}
