// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "output.h"

#include "common/interruption.h"
#include "common/option_values.h"
#include "core/base/parallel_for.h"
#include "pictures.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/pose_files.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <regex>
#include <string>
#include <system_error>
#include <vector>

namespace pcl_msf::tool {

namespace {

using Jobs = std::vector<std::function<void()>>;

/** \param folder must outlive the jobs, as the outcome */
void
addData (const Outcome& o,
         int frame,
         const Options& options,
         const std::filesystem::path& folder,
         Jobs& jobs)
{
  const SceneFlow& flow = o.result.frames[frame];
  const io::RgbdImages& reference = o.images[o.result.reference];
  const std::string pair = pairName (o, frame);
  const auto path = [folder, pair] (const std::string& name, const char* type) {
    return (folder / (name + pair + type)).string();
  };
  if (options.wants (Output::Cloud))
    jobs.push_back ([=, &flow, &reference] {
      io::writeSceneFlowCloud (
          path ("scene_flow", ".pcd"), flow, reference.color, reference.viewpoint);
    });
  if (options.wants (Output::Warped))
    jobs.push_back ([=, &flow, &reference] {
      io::writeWarpedCloud (
          path ("warped", ".pcd"), flow, reference.color, reference.viewpoint);
    });
  if (options.wants (Output::Flow))
    jobs.push_back ([=, &flow] { io::writeFlow (path ("flow", ".flo"), flow.flow); });
  if (options.wants (Output::Visibility))
    jobs.push_back ([=, &flow] {
      io::writeImage (path ("visibility", ".png"), flow.visibility);
      io::writeImage (path ("visible", ".png"), io::visibilityMask (flow.visibility));
    });
}

/** What belongs to the window as a whole. */
void
addWindow (const Outcome& o,
           const Options& options,
           const std::filesystem::path& folder,
           Jobs& jobs)
{
  const std::string reference = std::to_string (o.reference());
  if (options.wants (Output::Labels))
    jobs.push_back ([=, &o] {
      io::writeLabels ((folder / ("labels_" + reference + ".png")).string(),
                       o.lastFlow().labels);
      io::writeLabels ((folder / ("bodies_" + reference + ".png")).string(),
                       io::groupImage (o.lastFlow()));
    });
  if (options.wants (Output::Poses) && o.result.frames.size() > 2)
    for (const char* type : {".yaml", ".json"})
      jobs.push_back ([=, &o] {
        io::writePoses (
            (folder / ("poses_" + reference + type)).string(), o.result, o.indices);
      });
}

void
copyFile (const std::filesystem::path& from, const std::filesystem::path& to)
{
  std::error_code failed;
  std::filesystem::copy_file (
      from, to, std::filesystem::copy_options::overwrite_existing, failed);
  if (failed)
    throw IoError (to.string() + ": cannot be written: " + failed.message());
}

} // namespace

std::string
pairName (const Outcome& outcome, int frame)
{
  return "_" + std::to_string (outcome.reference()) + "_" +
         std::to_string (outcome.indices[frame]);
}

void
writeOutcome (Outcome& outcome, const Options& options)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::filesystem::path folder = options.output;
  const int count = static_cast<int> (outcome.result.frames.size());
  Jobs jobs;
  addWindow (outcome, options, folder, jobs);
  for (int k = outcome.first_new; k < count; ++k)
    if (k != outcome.result.reference)
      addData (outcome, k, options, folder, jobs);
  parallelFor (threadCount (options.solver.threads),
               static_cast<int> (jobs.size()),
               1,
               [&jobs] (int i) {
                 throwIfInterrupted();
                 jobs[i]();
               });
  for (int k = outcome.first_new; k < count && options.wants (Output::Pictures); ++k)
    if (k != outcome.result.reference)
      writePictures (outcome, k, options);
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - begin;
  outcome.seconds.write = seconds.count();
  // Under the window's name and, for the last window, under one that is always there.
  const std::filesystem::path report =
      folder / ("report_" + std::to_string (outcome.reference()) + ".json");
  io::writeReport (report.string(),
                   outcome.lastFlow(),
                   outcome.seconds,
                   count,
                   outcome.images[outcome.result.reference].distortion);
  copyFile (report, folder / "report.json");
}

bool
isResultName (const std::string& name, int frames)
{
  static const std::regex names (
      "(flow|scene_flow|warped|visible|visibility|occlusion|residual|overlay|flicker)"
      "_([0-9]+)_([0-9]+)(_before|_after)?\\.(flo|png|pcd)|"
      "(labels|bodies|range|segments|motions|weights|convergence|overview)_([0-9]+)"
      "\\.png|(poses|report)_([0-9]+)\\.(yaml|json)|report\\.json|trajectory\\.txt");
  std::smatch parts;
  if (!std::regex_match (name, parts, names))
    return false;
  return std::none_of (parts.begin(), parts.end(), [frames] (const auto& part) {
    int number = -1;
    return parse (part.str(), number) && number >= frames;
  });
}

} // namespace pcl_msf::tool
