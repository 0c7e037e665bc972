// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "render/options.h"

namespace pcl_msf::tool {

/** \brief Is the input a folder that pcl_msf_register wrote? */
bool
isCloudResult (const RenderOptions& options);

/** \brief Draws clouds without a grid: before and after when --sequence names the
 * target's file, the moved source, parts with the joints' axes. \return exit status
 * \throws DisplayError, InvalidInput, IoError, UsageError, Interrupted */
int
renderClouds (const RenderOptions& options);

} // namespace pcl_msf::tool
