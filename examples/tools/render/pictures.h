// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/output_folder.h"
#include "render/inputs.h"
#include "render/options.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief What pictures of the same result have in common, as a group of an
 * OutputFolder. */
std::string
resultOf (const RenderOptions& options);

/** \brief Has pictures of another result and those of an animation go, those of other
 * kinds stay. \throws UsageError when somebody else's file is in the way */
void
prepareOutput (const RenderOptions& options, OutputFolder& output);

/** \brief Draws what the options ask for and writes it. \return the files
 * \throws DisplayError, InvalidInput, IoError, UsageError, Interrupted */
std::vector<std::string>
writeRenders (const RenderInputs& inputs,
              const RenderOptions& options,
              OutputFolder& output);

} // namespace pcl_msf::tool
