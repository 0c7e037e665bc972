// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pipeline.h"

namespace pcl_msf::tool {

/** \brief Writes the pictures of the result for a frame of the window and, for the last
 * one, an overview of them into the output folder. \throws IoError, Interrupted */
void
writePictures (const Outcome& outcome, int frame, const Options& options);

} // namespace pcl_msf::tool
