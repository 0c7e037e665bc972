// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Registers two clouds without a grid: files in, files out.
#include <pcl/console/print.h>

#include "common/command_line.h"
#include "common/input_files.h"
#include "common/interruption.h"
#include "common/output_folder.h"
#include "common/progress_line.h"
#include "common/tool_main.h"
#include "common/tuning_options.h"
#include "register/constraint_files.h"
#include <CLI/App.hpp>
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/point_files.h>
#include <pcl_msf/io/text_files.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_register";
constexpr const char* kSummary =
    "Registers an articulated or deforming body given as two clouds of points without "
    "a\n"
    "grid: its parts, their motions and joints, and where every point has gone. "
    "Lengths\n"
    "are in the unit of the files. Exit status: 0 = written and found, 3 = written "
    "but\n"
    "not found or cut short (stderr says why), else an error.";
constexpr int kNotFound = 3; // exit status; everything was written

struct RegisterOptions {
  std::string source;
  std::string target;
  std::string output;   ///< folder
  std::string segments; ///< file
  std::string pairs;    ///< file
  bool quiet{false};
  double brightness_weight{1.0};
  SolverParameters solver;
};

void
declareOptions (CLI::App& app, RegisterOptions& o)
{
  addText (
      app, "SOURCE", "FILE", "a .pcd, .ply or .obj; its points are followed", o.source)
      ->required();
  addText (app, "TARGET", "FILE", "a .pcd, .ply or .obj", o.target)->required();
  addText (app,
           "--output",
           "DIR",
           "folder for warped.ply, registered.pcd, parts.txt, joints.json, report.json",
           o.output)
      ->required();
  addText (app,
           "--segments",
           "FILE",
           "a label per source point a line, negative = none: own segments, each rigid",
           o.segments);
  addText (app,
           "--pairs",
           "FILE",
           "known pairs, \"SOURCE TARGET [WEIGHT]\" a line: indices from 0; weight 1 = "
           "right to about a point's distance, 1e6 = hard",
           o.pairs);
  addNumber (app,
             "--brightness-weight",
             "W",
             "of colours beside shapes where both files have some, 0 to 1000; 0 = "
             "shapes alone",
             o.brightness_weight);
  addNumber (app, "--threads", "N", "0 = all", o.solver.threads);
  addNumber (app, "--max-seconds", "S", "time budget, 0 = none", o.solver.max_seconds);
  addSwitch (
      app, "--merge-bodies", "join what moves as one part", o.solver.merge_bodies);
  addFlag (app, "--quiet", "print errors and warnings only", o.quiet);
  addTuningOptions (app);
  app.final_callback ([&o] {
    if (!(o.brightness_weight >= 0.0 && o.brightness_weight <= 1000.0))
      throw UsageError ("--brightness-weight must be 0 to 1000");
    std::string why;
    if (o.solver.isValid (&why))
      return;
    std::replace (why.begin(), why.end(), '_', '-');
    throw UsageError ("--" + why);
  });
}

bool
isResultName (const std::string& name)
{
  static const std::array<const char*, 5> names{
      "warped.ply", "registered.pcd", "parts.txt", "joints.json", "report.json"};
  return std::find (names.begin(), names.end(), name) != names.end();
}

std::string
partsText (const CloudFlow& flow)
{
  std::string text;
  for (const int part : flow.part)
    text += std::to_string (part) + "\n";
  return text;
}

void
writeResults (const std::string& folder,
              const CloudFlow& flow,
              const io::PointFile& source,
              double load_seconds,
              double total_seconds)
{
  io::writePointsPly (folder + "/warped.ply", flow.warped);
  io::writeRegisteredCloud (folder + "/registered.pcd", flow, source);
  io::writeText (folder + "/parts.txt", partsText (flow));
  io::writeJoints (folder + "/joints.json", flow);
  io::writeCloudReport (folder + "/report.json", flow, load_seconds, total_seconds);
}

void
printSummary (const CloudFlow& flow, double seconds, const std::string& folder)
{
  using namespace pcl::console;
  setVerbosityLevel (L_INFO);
  print_highlight ("%zu points, %zu parts, %zu joints, %.0f %% and %.0f %% of the "
                   "clouds found on each other\n",
                   flow.warped.size(),
                   flow.parts.size(),
                   flow.joints.size(),
                   100.0 * flow.explained_source,
                   100.0 * flow.explained_target);
  print_info ("[done, ");
  print_value ("%.1f", 1000.0 * seconds);
  print_info (" ms; written to ");
  print_value ("%s", folder.c_str());
  print_info ("]\n");
}

CloudFlow
estimate (const RegisterOptions& options,
          const io::PointFile& source,
          const io::PointFile& target)
{
  ProgressLine line (!options.quiet);
  line.stage ("surfaces");
  SolverParameters solver = options.solver;
  solver.progress = [&line] (const Progress& progress) {
    throwIfInterrupted();
    line.update (progress);
    return true;
  };
  CloudConstraints constraints;
  if (!options.pairs.empty())
    constraints.pairs = readPairs (options.pairs);
  std::vector<int> segments;
  if (!options.segments.empty())
    segments = readLabels (options.segments);
  CloudBrightness brightness;
  brightness.weight = options.brightness_weight;
  if (!source.colors.empty() && !target.colors.empty()) {
    brightness.source = io::brightnessOf (source);
    brightness.target = io::brightnessOf (target);
  }
  return CloudFlowEstimator (solver, constraints)
      .estimate (source.points, target.points, {}, segments, brightness);
}

double
secondsSince (std::chrono::steady_clock::time_point begin)
{
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin;
  return gone.count();
}

int
run (const RegisterOptions& options)
{
  const auto begin = std::chrono::steady_clock::now();
  InputFiles files;
  files.add (options.source);
  files.add (options.target);
  files.add (options.segments);
  files.add (options.pairs);
  const io::PointFile source = io::readPoints (options.source);
  const io::PointFile target = io::readPoints (options.target);
  const double load = secondsSince (begin);
  OutputFolder folder (options.output, kProgram);
  folder.check (files, isResultName);
  const CloudFlow flow = estimate (options, source, target);
  const double total = secondsSince (begin);
  writeResults (folder.stage(), flow, source, load, total);
  folder.publish();
  folder.finish();
  if (!options.quiet)
    printSummary (flow, total, options.output);
  if (!flow.report.converged)
    complain (kProgram,
              std::string ("warning: not converged (") +
                  toString (flow.report.stop_reason) + "): " + flow.report.message);
  return flow.report.converged ? 0 : kNotFound;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<RegisterOptions> (
      {kProgram, kSummary, declareOptions, run}, argc, argv);
}
