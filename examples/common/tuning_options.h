// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

namespace CLI {
class App;
}

namespace pcl_msf::tool {

/** \brief Adds what experiments need and the help does not show: --tuning NAME=VALUE
 * sets a tuned value, --list-tuning prints all names with value and range and ends. */
void
addTuningOptions (CLI::App& app);

} // namespace pcl_msf::tool
