// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "render/inputs.h"
#include "render/options.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Draws what the options ask for and writes it. \return the files
 * \throws DisplayError, InvalidInput, IoError, Interrupted */
std::vector<std::string>
writeRenders (const RenderInputs& inputs, const RenderOptions& options);

} // namespace pcl_msf::tool
