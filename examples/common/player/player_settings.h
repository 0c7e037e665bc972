// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/method_options.h"
#include <pcl_msf/io/datasets.h>

#include <optional>
#include <string>

namespace pcl_msf::tool {

/** \brief How a recording is played into the tracker. */
struct PlayerSettings : WindowSettings {
  PlayerSettings() { window = 0; }

  std::string source; ///< a recording's folder
  io::DatasetOptions reading;
  std::optional<double> rate; ///< frames a second; none = the recording's own times
  bool every_frame{false};    ///< as fast as possible, none dropped
  int queue{1};               ///< frames that may wait
};

/** \brief Adds --rate. */
CLI::Option*
addRateOption (CLI::App& app, PlayerSettings& settings);

} // namespace pcl_msf::tool
