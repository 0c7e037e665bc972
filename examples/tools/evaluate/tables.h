// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "score.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief All Markdown tables that say something about these rows. */
std::string
allTables (const std::vector<Row>& rows);

/** \brief Everything about one method, a line per pair: flow, scene flow, motions,
 * residuals and times. */
std::string
detailTables (const std::vector<Row>& rows, const std::string& method);

/** \brief The end-point errors that the method's paper reports for MPI-Sintel (its
 * Table 1 and section 4.1), beside ours; empty without any of these sequences. */
std::string
sintelTable (const std::vector<Row>& rows);

/** \brief Change of error and time by the l1 and l2 norms, beside the paper's (section
 * 4.1); empty unless `msf` and one of them were run. */
std::string
ablationTable (const std::vector<Row>& rows);

} // namespace pcl_msf::tool
