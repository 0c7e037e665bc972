// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "render/options.h"

namespace pcl_msf::tool {

/** \brief Adds all options of pcl_msf_render, bound to the fields of `options`, which
 * must outlive the application. */
void
addRenderOptions (CLI::App& app, RenderOptions& options);

} // namespace pcl_msf::tool
