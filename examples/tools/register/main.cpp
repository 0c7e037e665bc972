// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Registers clouds without a grid: files in, files out.
#include "common/command_line.h"
#include "common/input_files.h"
#include "common/interruption.h"
#include "common/output_folder.h"
#include "common/progress_line.h"
#include "common/tool_main.h"
#include "common/tuning_options.h"
#include "register/constraint_files.h"
#include "register/results.h"
#include <CLI/App.hpp>
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/point_files.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_register";
constexpr const char* kSummary =
    "Registers an articulated or deforming body given as clouds of points without a\n"
    "grid: its parts, their motions and joints, and where every point has gone. "
    "Several\n"
    "targets, in the order of time, are registered jointly and have the same parts. "
    "Lengths\n"
    "are in the unit of the files. Exit status: 0 = written and found, 3 = written "
    "but\n"
    "not found or cut short (stderr says why), else an error.";
constexpr int kNotFound = 3; // exit status; everything was written

struct RegisterOptions {
  std::string source;               ///< file
  std::vector<std::string> targets; ///< files
  std::string output;               ///< folder
  std::string segments;             ///< file
  std::string pairs;                ///< file
  bool quiet{false};
  double brightness_weight{1.0};
  SolverParameters solver;
  MultiframeParameters multiframe;
};

void
declareOptions (CLI::App& app, RegisterOptions& o)
{
  addText (
      app, "SOURCE", "FILE", "a .pcd, .ply or .obj; its points are followed", o.source)
      ->required();
  addTexts (
      app, "TARGET", "FILE", "another one, or several in the order of time", o.targets)
      ->required();
  addText (
      app,
      "--output",
      "DIR",
      "folder for warped.ply, registered.pcd, parts.txt, joints.json, report.json; "
      "of several targets warped_0_1.ply, warped_0_2.ply and so on",
      o.output)
      ->required();
  addText (app,
           "--segments",
           "FILE",
           "a label per source point a line, negative = none: own segments, each rigid",
           o.segments);
  addText (
      app,
      "--pairs",
      "FILE",
      "known pairs, \"SOURCE TARGET [WEIGHT [K]]\" a line: indices from 0; weight 1 = "
      "right to about a point's distance, 1e6 = hard; of the K-th target, from 1",
      o.pairs);
  addNumber (app,
             "--brightness-weight",
             "W",
             "of colours beside shapes where both files have some, 0 to 1000; 0 = "
             "shapes alone",
             o.brightness_weight);
  addNumber (app,
             "--concatenation-weight",
             "W",
             "of several targets, lambda of Eq. 14",
             o.multiframe.concatenation_weight);
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
    if (o.solver.isValid (&why) && o.multiframe.isValid (&why))
      return;
    std::replace (why.begin(), why.end(), '_', '-');
    throw UsageError ("--" + why);
  });
}

CloudConstraints
constraintsOf (const RegisterOptions& options, const std::vector<io::PointFile>& clouds)
{
  CloudConstraints constraints;
  if (options.pairs.empty())
    return constraints;
  std::vector<std::size_t> targets;
  for (std::size_t k = 1; k < clouds.size(); ++k)
    targets.push_back (clouds[k].points.size());
  constraints.pairs = readPairs (options.pairs, clouds[0].points.size(), targets);
  return constraints;
}

/** \return per target; \param clouds the source, then the targets */
std::vector<CloudFlow>
estimate (const RegisterOptions& options, const std::vector<io::PointFile>& clouds)
{
  ProgressLine line (!options.quiet);
  line.stage ("surfaces");
  SolverParameters solver = options.solver;
  solver.progress = [&line] (const Progress& progress) {
    throwIfInterrupted();
    line.update (progress);
    return true;
  };
  const CloudConstraints constraints = constraintsOf (options, clouds);
  std::vector<int> segments;
  if (!options.segments.empty())
    segments = readLabels (options.segments, clouds[0].points.size());
  std::vector<CloudFrame> frames;
  for (const io::PointFile& cloud : clouds)
    frames.push_back ({cloud.points, io::brightnessOf (cloud)});
  std::vector<CloudFlow> flows =
      CloudFlowEstimator (solver, constraints, options.multiframe)
          .estimateWindow (frames, 0, {}, segments, options.brightness_weight);
  flows.erase (flows.begin()); // the source's own
  return flows;
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
  files.add (options.segments);
  files.add (options.pairs);
  std::vector<std::string> names = options.targets;
  names.insert (names.begin(), options.source);
  for (const std::string& name : names)
    files.add (name);
  std::vector<io::PointFile> clouds;
  for (const std::string& name : names)
    clouds.push_back (io::readPoints (name));
  RegisterResults results;
  results.load_seconds = secondsSince (begin);
  OutputFolder folder (options.output, kProgram);
  folder.check (files, isResultName);
  results.flows = estimate (options, clouds);
  results.source = std::move (clouds.front());
  results.total_seconds = secondsSince (begin);
  writeResults (results, folder.stage());
  folder.publish();
  folder.finish();
  if (!options.quiet)
    printSummary (results, options.output);
  const Report& report = results.verdict().report;
  if (!report.converged)
    complain (kProgram,
              std::string ("warning: not converged (") + toString (report.stop_reason) +
                  "): " + report.message);
  return report.converged ? 0 : kNotFound;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<RegisterOptions> (
      {kProgram, kSummary, declareOptions, run}, argc, argv);
}
