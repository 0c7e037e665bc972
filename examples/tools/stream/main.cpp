// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// A camera, or a recording played as one would deliver it, into the tracker.
#include "common/input_files.h"
#include "common/interruption.h"
#include "common/kept_memory.h"
#include "common/output_folder.h"
#include "common/player/frame_player.h"
#include "common/player/open_source.h"
#include "common/player/stream_tracker.h"
#include "common/standard_streams.h"
#include "common/tool_main.h"
#include "io/base/output_file.h"
#include "stream/options.h"
#include "stream/statistics.h"
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/pose_files.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_stream";
constexpr int kLostFrames = 3; // exit status; everything else was written

void
warn (const std::string& text)
{
  complain (kProgram, "warning: " + text);
}

void
print (const std::string& line)
{
  std::printf ("%s\n", line.c_str());
  std::fflush (stdout); // whoever reads a pipe wants it now
}

/** The folder of results; does nothing when none is wanted. */
class StreamOutput {
public:
  explicit StreamOutput (const StreamOptions& options) : flow_ (options.flow)
  {
    if (options.output.empty())
      return;
    InputFiles files;
    if (!options.isCamera()) {
      requireOutside ("--output", options.output, folderOf (options.source));
      files.add (options.source, options.output);
    }
    folder_ = std::make_unique<OutputFolder> (options.output, kProgram);
    folder_->check (files, [] (const std::string& name) {
      static const std::regex names (
          "flow_[0-9]+_[0-9]+\\.flo|trajectory\\.txt|report\\.json");
      return std::regex_match (name, names);
    });
  }
  void
  add (const StreamResult& result, double seconds, const SceneFlow& flow)
  {
    poses_.push_back ({seconds, result.camera});
    if (folder_ && flow_ && !result.first)
      io::writeFlow (path ("flow_" + std::to_string (result.reference) + "_" +
                           std::to_string (result.index) + ".flo"),
                     flow.flow);
  }
  void
  finish (const std::string& report)
  {
    if (!folder_)
      return;
    io::writeTrajectory (path ("trajectory.txt"), poses_);
    io::writeBytes (path ("report.json"), report.data(), report.size());
    folder_->finish();
  }

private:
  /** Of a list, that which it is in. */
  static std::string
  folderOf (const std::string& source)
  {
    const std::filesystem::path path = source;
    if (std::filesystem::is_directory (path))
      return source;
    return path.has_parent_path() ? path.parent_path().string() : ".";
  }
  std::string
  path (const std::string& name) const
  {
    return folder_->stage() + "/" + name;
  }

  bool flow_;
  std::unique_ptr<OutputFolder> folder_;
  std::vector<io::TimedPose> poses_;
};

/** Until the stream ends, a signal comes, or nobody gets results any more. */
void
playInto (StreamOutput& output,
          StreamStatistics& statistics,
          FrameSource& source,
          const StreamOptions& options)
{
  PlayerSettings settings = options;
  settings.dense = options.flow;
  StreamTracker tracker (settings);
  FramePlayer::Queue queue (options.queue);
  FramePlayer player (source, queue);
  while (const auto frame = queue.pop()) {
    if (interrupted())
      break;
    const StreamResult result = tracker.take (*frame);
    if (result.cancelled)
      break;
    statistics.setDropped (queue.dropped() + source.skipped());
    statistics.add (result);
    if (!result.problem.empty()) {
      warn ("frame " + std::to_string (result.index) + ": lost: " + result.problem);
      continue;
    }
    output.add (result, frame->seconds, tracker.sceneFlow());
    if (!options.quiet)
      print (statistics.line (result));
    if (options.output.empty() && standardOutputIsLost())
      break; // nobody gets what would come
  }
  queue.close();
  player.requireFrames();
}

int
run (const StreamOptions& options)
{
  keepFreedMemory();
  const auto source = openSource (options, warn);
  limitThreads (options);
  StreamOutput output (options);
  StreamStatistics statistics;
  playInto (output, statistics, *source, options);
  if (statistics.tracked() == 0)
    throwIfInterrupted();
  output.finish (statistics.json (options.source, interrupted()));
  if (!options.quiet)
    print (statistics.summary() +
           (options.output.empty() ? "" : "; written to " + options.output));
  if (interrupted())
    return interruptedStatus();
  return statistics.lost() > 0 ? kLostFrames : 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<StreamOptions> (
      {kProgram, kStreamSummary, declareStreamOptions, run}, argc, argv);
}
