// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pipeline.h"

namespace pcl_msf::tool {

/** \brief Writes the result's pictures and an overview of them into the output folder.
 * \throws IoError, Interrupted */
void
writePictures (const Outcome& outcome, const Options& options);

} // namespace pcl_msf::tool
