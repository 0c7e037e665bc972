// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/recordings.h"
#include <pcl_msf/visualization/result_scenes.h>

#include <string>

namespace pcl_msf::tool {

/** \brief Name of the file that holds a pair's scene flow. */
std::string
sceneFlowName (const ResultPair& pair);

/** \brief A pair that pcl_msf_scene_flow wrote into a folder: its scene flow and the
 * reference's colours; the current frame is not there. \throws IoError */
visualization::ResultClouds
readResult (const std::string& folder, const ResultPair& pair);

} // namespace pcl_msf::tool
