// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "common/command_line.h"
#include "render/options.h"
#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/visualization/result_scenes.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief What there is to show. */
struct RenderInputs {
  visualization::ResultClouds result;
  std::vector<cv::Mat> displacements; ///< frame 1, 2, ... of the window, CV_32FC3
};

/** \brief A result's two frames, by their places in the recording. */
struct ResultPair {
  int reference;
  int current;
};

/** \brief Pairs of frames that a folder of pcl_msf_scene_flow holds, by reference,
 * later frames before earlier ones; empty for any other folder. */
std::vector<ResultPair>
resultPairs (const std::string& folder);

/** \brief Options of what a recording does not say of itself. */
std::vector<Option>
readingOptions (io::DatasetOptions& options);

/** \brief The recording in a folder. \throws IoError, UsageError unless it is one */
std::shared_ptr<const io::RgbdSequence>
openFrames (const std::string& path, const io::DatasetOptions& options);

/** \brief Reads a result folder, or estimates the scene flow of a folder with frames.
 * \throws IoError, InvalidInput, UsageError, Interrupted */
RenderInputs
loadRenderInputs (const RenderOptions& options);

/** \brief Scene flow between two frames, with the default parameters.
 * \param go_on asked after every iteration; false gives up with Interrupted */
visualization::ResultClouds
estimatePair (io::RgbdImages reference,
              io::RgbdImages current,
              const std::function<bool()>& go_on);

} // namespace pcl_msf::tool
