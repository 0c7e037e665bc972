// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include "render/options.h"

#include <vector>

namespace pcl_msf::tool {

/** \brief All options of pcl_msf_render, bound to the fields of `options`, which must
 * outlive them. */
std::vector<Option>
renderOptionTable (RenderOptions& options);

} // namespace pcl_msf::tool
