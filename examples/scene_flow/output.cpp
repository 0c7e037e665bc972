// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "output.h"

#include "common/interruption.h"
#include "pictures.h"
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/pose_files.h>

#include <chrono>
#include <filesystem>
#include <string>

namespace pcl_msf::tool {

namespace {

void
writeData (const Outcome& o, int frame, const std::filesystem::path& folder)
{
  const SceneFlow& flow = o.result.frames[frame];
  const io::RgbdImages& reference = o.images[o.result.reference];
  const std::string pair = pairName (o, frame);
  const auto path = [&] (const std::string& name, const char* type) {
    return (folder / (name + pair + type)).string();
  };
  io::writeFlow (path ("flow", ".flo"), flow.flow);
  io::writeImage (path ("visibility", ".png"), flow.visibility);
  io::writeImage (path ("visible", ".png"), io::visibilityMask (flow.visibility));
  throwIfInterrupted();
  io::writeSceneFlowCloud (
      path ("scene_flow", ".pcd"), flow, reference.color, reference.viewpoint);
  throwIfInterrupted();
  io::writeWarpedCloud (
      path ("warped", ".pcd"), flow, reference.color, reference.viewpoint);
}

/** What belongs to the window as a whole. */
void
writeWindow (const Outcome& o, bool several, const std::filesystem::path& folder)
{
  const std::string reference = std::to_string (o.reference());
  io::writeLabels ((folder / ("labels_" + reference + ".png")).string(),
                   o.lastFlow().labels);
  io::writeLabels ((folder / ("bodies_" + reference + ".png")).string(),
                   io::bodyImage (o.lastFlow()));
  if (o.result.frames.size() <= 2)
    return;
  const std::string name = several ? "poses_" + reference : "poses";
  for (const char* type : {".yaml", ".json"})
    io::writePoses ((folder / (name + type)).string(), o.result, o.indices);
}

} // namespace

std::string
pairName (const Outcome& outcome, int frame)
{
  return "_" + std::to_string (outcome.reference()) + "_" +
         std::to_string (outcome.indices[frame]);
}

void
writeOutcome (Outcome& outcome, const Options& options, bool several)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::filesystem::path folder = options.output;
  const int count = static_cast<int> (outcome.result.frames.size());
  writeWindow (outcome, several, folder);
  for (int k = outcome.first_new; k < count; ++k)
    if (k != outcome.result.reference) {
      writeData (outcome, k, folder);
      writePictures (outcome, k, options, several);
    }
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - begin;
  outcome.seconds.write = seconds.count();
  const std::string report =
      several ? "report_" + std::to_string (outcome.reference()) : "report";
  io::writeReport ((folder / (report + ".json")).string(),
                   outcome.lastFlow(),
                   outcome.seconds,
                   count);
}

} // namespace pcl_msf::tool
