// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "output.h"

#include "interruption.h"
#include "pictures.h"
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <chrono>
#include <filesystem>

namespace pcl_msf::tool {

namespace {

void
writeData (const Outcome& o, const std::filesystem::path& folder)
{
  const SceneFlow& flow = o.scene_flow;
  const auto path = [&folder] (const char* name) { return (folder / name).string(); };
  io::writeFlow (path ("flow_0_1.flo"), flow.flow);
  io::writeLabels (path ("labels_0.png"), flow.labels);
  io::writeLabels (path ("bodies_0.png"), io::bodyImage (flow));
  io::writeImage (path ("visibility_0_1.png"), flow.visibility);
  io::writeImage (path ("visible_0_1.png"), io::visibilityMask (flow.visibility));
  throwIfInterrupted();
  io::writeSceneFlowCloud (path ("scene_flow_0_1.pcd"), flow, o.reference_color);
  throwIfInterrupted();
  io::writeWarpedCloud (path ("warped_0_1.pcd"), flow, o.reference_color);
}

} // namespace

void
writeOutcome (Outcome& outcome, const Options& options)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::filesystem::path folder = options.output;
  writeData (outcome, folder);
  writePictures (outcome, options);
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - begin;
  outcome.seconds.write = seconds.count();
  io::writeReport (
      (folder / "report.json").string(), outcome.scene_flow, outcome.seconds);
}

} // namespace pcl_msf::tool
