// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/table_text.h"
#include "summary.h"
#include "tables.h"
#include <pcl_msf/evaluation/flow_errors.h>

#include <cmath>

namespace pcl_msf::tool {

namespace {

/** A line of the paper's Table 1, or an error that its section 4.1 mentions. */
struct Published {
  const char* sequence;
  const char* method; ///< of ours that it is to be compared with
  double srsf;        ///< Quiroga et al., ECCV 2014
  double msf;
};

constexpr double kNone = -1.0;
constexpr Published kPublished[] = {{"alley_1", "msf", 2.46122, 0.740127},
                                    {"bandage_1", "msf", 2.47801, 1.69865},
                                    {"sleeping_2", "rigid", 1.13584, 0.307526},
                                    {"shaman_2", "msf", kNone, 0.354061},
                                    {"shaman_3", "msf", kNone, 1.00192},
                                    {"mountain_1", "msf", kNone, 1.6898},
                                    {"bandage_2", "msf", kNone, 1.0715}};

std::string
published (double value)
{
  return value == kNone ? "-" : cell (value, 3);
}

/** Relative change of a mean over the pairs that both methods have. */
double
changePercent (const std::vector<Row>& rows,
               const std::string& method,
               double Score::*value)
{
  double before = 0.0, after = 0.0;
  for (const Row& row : rows)
    for (const Row& other : rows)
      if (row.pair == other.pair && row.method == "msf" && other.method == method &&
          std::isfinite (row.score.*value) && std::isfinite (other.score.*value)) {
        before += row.score.*value;
        after += other.score.*value;
      }
  return 100.0 * (after / before - 1.0);
}

} // namespace

std::string
sintelTable (const std::vector<Row>& rows)
{
  TableText table ({"MPI-Sintel, average EPE, px",
                    "pairs",
                    "SRSF",
                    "MSF, paper",
                    "method",
                    "ours, all",
                    "ours, visible"});
  for (const Published& line : kPublished) {
    const auto all = valuesOf (rows, line.method, &Score::epe_all, line.sequence);
    const auto seen = valuesOf (rows, line.method, &Score::epe_visible, line.sequence);
    if (!all.empty())
      table.add ({line.sequence,
                  std::to_string (all.size()),
                  published (line.srsf),
                  published (line.msf),
                  line.method,
                  cell (evaluation::mean (all), 3),
                  cell (evaluation::mean (seen), 3)});
  }
  if (table.empty())
    return {};
  return "The paper's figures (its Table 1 and section 4.1) and ours\n\n" +
         table.text() + "\n";
}

std::string
ablationTable (const std::vector<Row>& rows)
{
  struct Variant {
    const char* method;
    const char* name;
    const char* paper;
  };
  const Variant variants[] = {{"msf:loss=l1", "l1", "EPE +4, time -5"},
                              {"msf:loss=l2", "l2", "EPE +40"}};
  TableText table ({"norm in place of Huber, %",
                    "EPE all",
                    "EPE visible",
                    "time",
                    "paper (alley_1)"});
  for (const Variant& v : variants)
    if (const double change = changePercent (rows, v.method, &Score::sec);
        std::isfinite (change))
      table.add ({v.name,
                  cell (changePercent (rows, v.method, &Score::epe_all), 1),
                  cell (changePercent (rows, v.method, &Score::epe_visible), 1),
                  cell (change, 1),
                  v.paper});
  if (table.empty())
    return {};
  return "Change of the mean by the norm of the data terms\n\n" + table.text() + "\n";
}

} // namespace pcl_msf::tool
