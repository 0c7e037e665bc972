// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Scene flow between RGB-D frames: files in, files out.
#include <pcl/console/print.h>

#include "common/input_files.h"
#include "common/kept_memory.h"
#include "common/one_line.h"
#include "common/outcome_text.h"
#include "common/output_folder.h"
#include "common/output_manifest.h"
#include "common/tool_main.h"
#include "merge_shards.h"
#include "options.h"
#include "output.h"
#include "pipeline.h"
#include "tracking.h"
#include "trajectory.h"
#include "window_log.h"

#include <algorithm>
#include <filesystem>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_scene_flow";
constexpr int kNotConverged = 3; // exit status; everything was written
constexpr const char* kRender = "pcl_msf_render";

void
printSummary (const Outcome& outcome, const std::string& folder)
{
  using namespace pcl::console;
  setVerbosityLevel (L_INFO);
  const io::RunSeconds& seconds = outcome.seconds;
  const SceneFlow& flow = outcome.lastFlow();
  print_highlight ("%zu segments, %d motion groups, %d iterations, %s\n",
                   flow.segments.size(),
                   flow.groups,
                   flow.report.iterations,
                   toString (flow.report.stop_reason));
  print_info ("[done, ");
  print_value ("%.1f", 1000.0 * seconds.total);
  print_info (" ms: load ");
  print_value ("%.1f", 1000.0 * seconds.load);
  print_info (", frames ");
  print_value ("%.1f", 1000.0 * seconds.frame);
  print_info (", segments ");
  print_value ("%.1f", 1000.0 * seconds.segment);
  print_info (", solve ");
  print_value ("%.1f", 1000.0 * flow.report.solve_seconds);
  print_info ("; written to ");
  print_value ("%s", folder.c_str());
  print_info ("]\n");
}

/** What others need of a window's result. */
WindowRecord
recordOf (const Outcome& outcome, const Inputs& inputs, int window)
{
  const MultiframeSceneFlow& result = outcome.result;
  WindowRecord record;
  record.window = window;
  record.frames = outcome.indices;
  record.reference = result.reference;
  record.converged = outcome.lastFlow().report.converged;
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    const bool reference = static_cast<int> (k) == result.reference;
    record.motions.push_back (reference ? RigidPose{}
                                        : result.frames[k].dominant_motion);
    record.seconds.push_back (inputs.timestamp (outcome.indices[k]));
  }
  return record;
}

/** \return has it converged? */
bool
warnUnlessConverged (const Outcome& outcome)
{
  const std::string problem = problemOf (outcome.lastFlow().report);
  if (!problem.empty())
    complain (kProgram,
              "warning: frames " + std::to_string (outcome.reference()) + " to " +
                  std::to_string (outcome.indices[outcome.lastTarget()]) + ": " +
                  problem);
  return problem.empty();
}

/** Where a run's files go, window by window. */
class Results {
public:
  /** \param windows of the recording */
  Results (const Options& options, const Inputs& inputs, int windows)
  : options_ (options)
  , folder_ (options.output, kProgram)
  , trajectory_ ((inputs.frames() > 2 || options.track) && !options.sharded())
  , log_ (options.settings, windows, options.shard)
  {
    const InputFiles files = inputFiles (options);
    for (const std::string& name : renders (OutputManifest (options.output, kRender)))
      requireNoInput ("--output", options.output + "/" + name, files);
    if (options.sharded()) {
      log_.resume (options.output);
      for (const auto& [window, record] : log_.records())
        converged_ = converged_ && record.converged;
      folder_.keep ([] (const std::string&, const std::string&) { return true; });
    }
    folder_.check (files, [&inputs] (const std::string& name) {
      return isResultName (name, inputs.frames()) || name == WindowLog::kName;
    });
  }
  /** Is this window this run's, and not done yet? */
  bool
  wants (int window) const
  {
    return options_.shard.has (window) && !log_.has (window);
  }
  void
  write (Outcome& outcome, const Trajectory& trajectory)
  {
    Options staged = options_;
    staged.output = folder_.stage();
    writeOutcome (outcome, staged);
    if (trajectory_)
      io::writeTrajectory (folder_.stage() + "/trajectory.txt", trajectory.poses());
    if (options_.sharded())
      log_.write (folder_.stage());
    folder_.publish();
    if (!options_.quiet)
      printSummary (outcome, options_.output);
    converged_ = warnUnlessConverged (outcome) && converged_;
  }
  /** Before its files are written. */
  void
  note (const WindowRecord& record)
  {
    log_.add (record);
  }
  void
  finish ()
  {
    folder_.finish();
    OutputManifest pictures (options_.output, kRender);
    for (const std::string& name : renders (pictures))
      pictures.remove (name);
    pictures.write();
  }
  /** Has all that was written? */
  bool
  converged () const
  {
    return converged_;
  }

private:
  /** What pcl_msf_render has drawn into the folder of the result that is in it. */
  std::vector<std::string>
  renders (const OutputManifest& pictures) const
  {
    const std::string result =
        oneLine (std::filesystem::canonical (options_.output).string());
    std::vector<std::string> names;
    for (const auto& [name, entry] : pictures.entries())
      if (entry.group.rfind (result + " ", 0) == 0)
        names.push_back (name);
    return names;
  }
  static InputFiles
  inputFiles (const Options& options)
  {
    InputFiles files;
    for (const auto& paths : {options.color, options.depth, options.cloud})
      for (const std::string& path : paths)
        files.add (path);
    files.add (options.labels);
    files.add (options.sequence, options.output);
    return files;
  }

  const Options& options_;
  OutputFolder folder_;
  bool trajectory_;
  WindowLog log_;
  bool converged_{true};
};

/** Windows share a frame. */
int
windowsOf (const Inputs& inputs)
{
  const int step = inputs.window() - 1;
  return (inputs.frames() - 1 + step - 1) / step;
}

void
runWindows (const Options& options, Inputs& inputs, Results& results)
{
  Trajectory trajectory;
  const int step = inputs.window() - 1;
  for (int window = 0; window < windowsOf (inputs); ++window) {
    if (!results.wants (window))
      continue;
    const int first = window * step;
    const int count = std::min (inputs.window(), inputs.frames() - first);
    Outcome outcome = runPipeline (options, inputs, first, count);
    const WindowRecord record = recordOf (outcome, inputs, window);
    trajectory.add (record);
    results.note (record);
    results.write (outcome, trajectory);
  }
}

void
runTracking (const Options& options, Inputs& inputs, Results& results)
{
  Trajectory trajectory;
  Tracking tracking (options, inputs);
  for (int frame = 0; frame < inputs.frames(); ++frame) {
    Outcome outcome = tracking.next();
    trajectory.add (inputs.timestamp (frame), tracking.cameraPose());
    if (frame > 0)
      results.write (outcome, trajectory);
  }
}

/** Named after the recording: in the current folder, but beside the recording when that
 * holds the current folder. */
std::string
standardOutput (const std::string& sequence)
{
  namespace fs = std::filesystem;
  const fs::path recording = fs::canonical (sequence);
  const std::string name = recording.filename().string();
  if (name.empty())
    throw UsageError (
        "--output: missing; '" + sequence +
        "' has no name to call the results after; give a folder for them");
  const fs::path here = fs::current_path();
  const auto parted =
      std::mismatch (recording.begin(), recording.end(), here.begin(), here.end());
  const bool inside = parted.first == recording.end();
  return ((inside ? recording.parent_path() : fs::path()) / (name + "_scene_flow"))
      .string();
}

int
run (const Options& given)
{
  keepFreedMemory();
  Options options = given;
  if (options.merge)
    return mergeShards (options.output, kProgram) ? 0 : kNotConverged;
  Inputs inputs (options, [] (const std::string& problem) {
    complain (kProgram, "warning: " + problem);
  });
  if (options.output.empty())
    options.output = standardOutput (options.sequence);
  requireOutside ("--output", options.output, options.sequence);
  if (options.sharded())
    options.output = folderOfShard (options.output, options.shard);
  Results results (options, inputs, windowsOf (inputs));
  if (options.track)
    runTracking (options, inputs, results);
  else
    runWindows (options, inputs, results);
  results.finish();
  return results.converged() ? 0 : kNotConverged;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<Options> ({kProgram, kSummary, declareOptions, run}, argc, argv);
}
