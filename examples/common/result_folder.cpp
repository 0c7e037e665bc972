// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/result_folder.h"

#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/result_files.h>

#include <filesystem>
#include <utility>

namespace pcl_msf::tool {

namespace fs = std::filesystem;

namespace {

/** Motion groups and visibility, which the cloud does not hold. */
void
addImages (const fs::path& folder, const ResultPair& pair, SceneFlow& flow)
{
  const std::string reference = std::to_string (pair.reference);
  const std::string bodies = (folder / ("bodies_" + reference + ".png")).string();
  if (fs::exists (bodies))
    io::setGroups (io::readLabels (bodies), flow);
  else
    flow.segments.clear();
  const std::string seen = (folder / ("visibility_" + reference + "_" +
                                      std::to_string (pair.current) + ".png"))
                               .string();
  if (!fs::exists (seen))
    return;
  flow.visibility = io::readColor (seen);
  if (flow.visibility.type() != CV_8UC1 || flow.visibility.size() != flow.labels.size())
    throw IoError (seen + ": image: " + std::to_string (flow.visibility.cols) + "x" +
                   std::to_string (flow.visibility.rows) + ", the scene flow " +
                   std::to_string (flow.labels.cols) + "x" +
                   std::to_string (flow.labels.rows) +
                   "; give the folder as pcl_msf_scene_flow wrote it");
}

} // namespace

std::string
sceneFlowName (const ResultPair& pair)
{
  return "scene_flow_" + std::to_string (pair.reference) + "_" +
         std::to_string (pair.current) + ".pcd";
}

visualization::ResultClouds
readResult (const std::string& folder, const ResultPair& pair)
{
  io::StoredSceneFlow stored =
      io::readSceneFlowCloud ((fs::path (folder) / sceneFlowName (pair)).string());
  visualization::ResultClouds result;
  result.scene_flow = std::move (stored.scene_flow);
  result.reference_color = stored.color;
  addImages (folder, pair, result.scene_flow);
  return result;
}

} // namespace pcl_msf::tool
