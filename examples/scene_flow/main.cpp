// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Scene flow between RGB-D frames: files in, files out.
#include <pcl/console/print.h>

#include "common/tool_main.h"
#include "options.h"
#include "output.h"
#include "pipeline.h"
#include "tracking.h"
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/pose_files.h>

#include <algorithm>
#include <filesystem>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_scene_flow";
constexpr int kNotConverged = 3; // exit status; everything was written

void
printSummary (const Outcome& outcome, const std::string& folder)
{
  using namespace pcl::console;
  setVerbosityLevel (L_INFO);
  const io::RunSeconds& seconds = outcome.seconds;
  const SceneFlow& flow = outcome.lastFlow();
  print_highlight ("%zu segments, %d motion groups, %d iterations, %s\n",
                   flow.segments.size(),
                   flow.bodies,
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

/** Camera poses from the windows' dominant motions; each window goes on where the last
 * one ended. */
class Trajectory {
public:
  void
  add (const Outcome& outcome, const Inputs& inputs)
  {
    const MultiframeSceneFlow& result = outcome.result;
    // The window's frame 0 is the last one's last.
    const RigidPose world_from_reference =
        last_ *
        (result.reference == 0 ? RigidPose{} : result.frames[0].dominant_motion);
    for (std::size_t k = poses_.empty() ? 0 : 1; k < result.frames.size(); ++k) {
      const RigidPose motion = static_cast<int> (k) == result.reference
                                   ? RigidPose{}
                                   : result.frames[k].dominant_motion;
      poses_.push_back ({inputs.timestamp (outcome.indices[k]),
                         world_from_reference * motion.inverse()});
    }
    last_ = poses_.back().world_from_camera;
  }
  void
  add (double seconds, const RigidPose& world_from_camera)
  {
    poses_.push_back ({seconds, world_from_camera});
  }
  const std::vector<io::TimedPose>&
  poses () const
  {
    return poses_;
  }

private:
  std::vector<io::TimedPose> poses_;
  RigidPose last_; ///< world_from_camera of the last frame so far
};

/** \return has it converged? */
bool
writeAll (Outcome& outcome, const Options& options, bool several)
{
  writeOutcome (outcome, options, several);
  if (!options.quiet)
    printSummary (outcome, options.output);
  const Report& report = outcome.lastFlow().report;
  if (!report.converged)
    complain (kProgram,
              "warning: frames " + std::to_string (outcome.reference()) + " to " +
                  std::to_string (outcome.indices[outcome.lastTarget()]) +
                  ": not converged (" + toString (report.stop_reason) + ")" +
                  (report.message.empty() ? "" : " ") + report.message);
  return report.converged;
}

void
writePoses (const Trajectory& trajectory, const Options& options)
{
  io::writeTrajectory (
      (std::filesystem::path (options.output) / "trajectory.txt").string(),
      trajectory.poses());
}

/** Windows that share a frame. \return have all converged? */
bool
runWindows (const Options& options, const Inputs& inputs)
{
  bool converged = true;
  Trajectory trajectory;
  const bool several = inputs.frames() > inputs.window();
  const int step = inputs.window() - 1;
  for (int first = 0; first + 1 < inputs.frames(); first += step) {
    const int count = std::min (inputs.window(), inputs.frames() - first);
    Outcome outcome = runPipeline (options, inputs, first, count);
    converged = writeAll (outcome, options, several) && converged;
    trajectory.add (outcome, inputs);
    if (inputs.frames() > 2)
      writePoses (trajectory, options);
  }
  return converged;
}

/** \return have all windows converged? */
bool
runTracking (const Options& options, const Inputs& inputs)
{
  bool converged = true;
  Trajectory trajectory;
  Tracking tracking (options, inputs);
  for (int frame = 0; frame < inputs.frames(); ++frame) {
    Outcome outcome = tracking.next();
    if (frame > 0)
      converged = writeAll (outcome, options, true) && converged;
    trajectory.add (inputs.timestamp (frame), tracking.cameraPose());
    writePoses (trajectory, options);
  }
  return converged;
}

int
run (const Options& given)
{
  Options options = given;
  const Inputs inputs (options);
  if (options.output.empty())
    options.output = std::filesystem::absolute (options.sequence + "/.")
                         .parent_path()
                         .filename()
                         .string() +
                     "_scene_flow";
  io::makeFolder (options.output);
  const bool converged =
      options.track ? runTracking (options, inputs) : runWindows (options, inputs);
  return converged ? 0 : kNotConverged;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<Options> ({kProgram, parseOptions, printHelp, run}, argc, argv);
}
