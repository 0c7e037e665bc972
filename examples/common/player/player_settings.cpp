// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/player_settings.h"

#include <CLI/App.hpp>

namespace pcl_msf::tool {

CLI::Option*
addRateOption (CLI::App& app, PlayerSettings& settings)
{
  return addOption (app,
                    "--rate",
                    "HZ",
                    "frames a second, above 0 [by the recording's times, else 30]",
                    [&settings] (const std::string& text) {
                      return parse (text, settings.rate.emplace()) &&
                             *settings.rate > 0.0;
                    });
}

} // namespace pcl_msf::tool
