// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "score.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief The methods of the rows, in order of appearance. */
std::vector<std::string>
methodsOf (const std::vector<Row>& rows);

/** \brief Markdown: a line per pair, a column per method, the best in bold, mean and
 * median of all lines. Empty when no row has the number.
 * \param scale multiplies what is printed, e.g. 1000 for m as mm */
std::string
methodTable (const std::vector<Row>& rows,
             const std::string& title,
             const std::string& column,
             double scale,
             int decimals);

/** \brief Markdown: a line per pair, all numbers of one method that its rows have. */
std::string
detailTable (const std::vector<Row>& rows, const std::string& method);

/** \brief Markdown: a line per method, means over the pairs. */
std::string
summaryTable (const std::vector<Row>& rows);

/** \brief All tables that say something about these rows. */
std::string
allTables (const std::vector<Row>& rows);

} // namespace pcl_msf::tool
