// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/method_options.h"
#include <pcl_msf/io/datasets.h>

#include <optional>
#include <string>

namespace pcl_msf::tool {

/** \brief Which of PCL's grabbers a stream comes from. */
enum class GrabberKind {
  None, ///< a recording that io reads
  PcdFiles,
  ImageFiles,
  OpenNI2,
  RealSense2
};

/** \brief How a recording is played, or a camera followed, into the tracker. */
struct PlayerSettings : WindowSettings {
  PlayerSettings() { window = 0; }

  std::string source; ///< a recording's folder, or a camera's number or name
  GrabberKind grabber{GrabberKind::None};
  io::DatasetOptions reading;
  std::optional<double> rate; ///< frames a second; none = the recording's own times
  bool every_frame{false};    ///< as fast as possible, none dropped
  int queue{1};               ///< frames that may wait
  bool dense{true};           ///< results have images
  bool halve_large{false};    ///< frames of many pixels begin at finest level 1

  /** \brief Live, so that it has a rate of its own and is no folder. */
  bool
  isCamera () const
  {
    return grabber == GrabberKind::OpenNI2 || grabber == GrabberKind::RealSense2;
  }
};

/** \brief Adds --rate. */
CLI::Option*
addRateOption (CLI::App& app, PlayerSettings& settings);

/** \brief Adds --grabber. */
CLI::Option*
addGrabberOption (CLI::App& app, PlayerSettings& settings);

/** \brief To be called when all is read. \throws UsageError unless there is a source
 * and the other options are of use with it \param name what the tool calls it */
void
checkSource (const PlayerSettings& settings, const std::string& name);

} // namespace pcl_msf::tool
