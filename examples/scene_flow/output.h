// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pipeline.h"

#include <string>

namespace pcl_msf::tool {

/** \brief "_0_1": from the reference to a frame of the window, as in file names. */
std::string
pairName (const Outcome& outcome, int frame);

/** \brief Writes all files of a window's result, its report last; notes the time that
 * took in the outcome. \param several one of many windows: names of files that belong
 * to the window end with its reference \throws IoError, Interrupted */
void
writeOutcome (Outcome& outcome, const Options& options, bool several);

} // namespace pcl_msf::tool
