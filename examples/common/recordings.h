// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include <pcl_msf/io/datasets.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A result's two frames, by their places in the recording. */
struct ResultPair {
  int reference;
  int current;
};

/** \brief Pairs of frames that a folder of pcl_msf_scene_flow holds, by reference,
 * later frames before earlier ones; empty for any other folder. */
std::vector<ResultPair>
resultPairs (const std::string& folder);

/** \brief Adds --camera FX,FY,CX,CY. */
CLI::Option*
addCamera (CLI::App& app, const std::string& help, std::optional<PinholeCamera>& value);

/** \brief Adds an option for K1,K2,P1,P2[,K3]. \param take is called with the lens */
CLI::Option*
addDistortion (CLI::App& app,
               const std::string& name,
               const std::string& help,
               const std::function<void (const LensDistortion&)>& take);

/** \brief Adds --distortion: the frames' images are freed from it. */
CLI::Option*
addDistortion (CLI::App& app,
               const std::string& help,
               std::optional<LensDistortion>& value);

/** \brief Adds --depth-scale, units per metre, above 0. */
CLI::Option*
addDepthScale (CLI::App& app, const std::string& help, std::optional<double>& value);

/** \brief Adds --max-time-difference, seconds, above 0. */
CLI::Option*
addMaxTimeDifference (CLI::App& app, const std::string& help, double& value);

/** \brief Adds the options of what a recording does not say of itself. */
void
addReadingOptions (CLI::App& app, io::DatasetOptions& options);

/** \brief The recording in a folder. \throws IoError, UsageError unless it is one */
std::shared_ptr<const io::RgbdSequence>
openFrames (const std::string& path, const io::DatasetOptions& options);

/** \brief The same for a folder that might be one of results, of which none can be
 * shown: those of pcl_msf_stream, or without their clouds. \throws UsageError that says
 * what is missing */
std::shared_ptr<const io::RgbdSequence>
openFramesNotResults (const std::string& path, const io::DatasetOptions& options);

/** \throws UsageError when a recording has no such frame */
void
requireFrame (const io::RgbdSequence& frames, int frame);

} // namespace pcl_msf::tool
