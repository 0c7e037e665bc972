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
 * took in the outcome. \param options its `output` is where to write \throws IoError,
 * Interrupted */
void
writeOutcome (Outcome& outcome, const Options& options);

/** \brief Could a run over so many frames write a file of this name? Names tell what is
 * in the file and which frames it is about, "flow_0_1.flo", "labels_0.png"; they are
 * the same for pairs, windows and tracking, and none that a recording has. */
bool
isResultName (const std::string& name, int frames);

} // namespace pcl_msf::tool
