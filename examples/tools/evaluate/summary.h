// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pair_table.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief The methods of the rows, in order of appearance. */
std::vector<std::string>
methodsOf (const std::vector<Row>& rows);

/** \brief The sequences of the rows, in order of appearance. */
std::vector<std::string>
sequencesOf (const std::vector<Row>& rows);

/** \brief Names of pairs by their number: the sequence, with the frames unless it has
 * this pair only. */
std::map<std::size_t, std::string>
pairNames (const std::vector<Row>& rows);

/** \brief A number of all rows of a method; unknown ones are left out.
 * \param sequence of these rows only; empty = of all */
std::vector<double>
valuesOf (const std::vector<Row>& rows,
          const std::string& method,
          double Score::*value,
          const std::string& sequence = {});

/** \brief One row per sequence and method with the means of its pairs' numbers; pairs
 * are numbered by sequence. */
std::vector<Row>
meansPerSequence (const std::vector<Row>& rows);

/** \brief The camera's path over successive pairs of a sequence. */
struct PathErrors {
  std::string sequence;
  std::string method;
  int poses{0};
  double ate_m;   ///< absolute trajectory error, root mean square
  double rpe_m;   ///< relative pose error of successive used frames
  double rpe_deg; ///< likewise
};

/** \brief Path errors where at least two successive pairs have estimated and true
 * motion. */
std::vector<PathErrors>
pathErrors (const std::vector<Row>& rows);

/** \brief Rows, means and medians over all rows and per sequence, paths, as JSON. */
std::string
jsonText (const ResultFile& results);

/** \brief Does a text begin as jsonText() does? */
bool
isResultsJson (const std::string& text);

} // namespace pcl_msf::tool
