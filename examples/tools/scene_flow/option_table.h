// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "options.h"

namespace pcl_msf::tool {

/** \brief Adds all options, bound to the fields of `options`, which must outlive the
 * application. */
void
addSceneFlowOptions (CLI::App& app, Options& options);

} // namespace pcl_msf::tool
