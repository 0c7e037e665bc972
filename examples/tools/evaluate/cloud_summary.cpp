// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "cloud_table.h"
#include "common/table_text.h"
#include "io/base/json.h"
#include <pcl_msf/version.h>

#include <cmath>
#include <map>

namespace pcl_msf::tool {

namespace {

/** Of a method, over the cases that all methods have answered; NaN without any. */
struct Means {
  int cases{0};
  int converged{0};
  double mean{0.0};
  double within{0.0};
  double seconds{0.0};
};

Means
meansOf (const CloudTable& table, const std::string& method)
{
  std::map<int, std::size_t> answers;
  for (const CloudRow& row : table.rows)
    ++answers[row.number];
  Means means;
  for (const CloudRow& row : table.rows)
    if (row.method == method && answers[row.number] == table.methods.size()) {
      means.mean += row.score.mean;
      means.within += row.score.within;
      means.seconds += row.seconds;
      means.converged += row.converged ? 1 : 0;
      ++means.cases;
    }
  const double n = means.cases > 0 ? means.cases : std::nan ("");
  means.mean /= n;
  means.within /= n;
  means.seconds /= n;
  return means;
}

std::string
rowsText (const CloudTable& results)
{
  TableText table ({"case",
                    "method",
                    "mean mm",
                    "median mm",
                    "95 % mm",
                    "< 10 mm %",
                    "converged",
                    "s"});
  for (const CloudRow& row : results.rows)
    table.add ({row.name,
                row.method,
                cell (1e3 * row.score.mean, 2),
                cell (1e3 * row.score.median, 2),
                cell (1e3 * row.score.p95, 2),
                cell (100.0 * row.score.within, 1),
                row.converged ? "yes" : "no",
                cell (row.seconds, 2)});
  return table.text();
}

} // namespace

std::string
tablesText (const CloudTable& results)
{
  TableText table ({"method", "cases", "mean mm", "< 10 mm %", "converged", "s"});
  for (const std::string& method : results.methods) {
    const Means means = meansOf (results, method);
    table.add ({method,
                std::to_string (means.cases),
                cell (1e3 * means.mean, 2),
                cell (100.0 * means.within, 1),
                std::to_string (means.converged),
                cell (means.seconds, 2)});
  }
  return rowsText (results) + "\n" + table.text();
}

std::string
jsonText (const CloudTable& table)
{
  io::Json json{{"version", PCL_MSF_VERSION_PRETTY},
                {"settings", table.settings},
                {"shard", table.shard.text()},
                {"cases", table.cases},
                {"summary", io::Json::object()},
                {"rows", io::Json::array()}};
  for (const std::string& method : table.methods) {
    const Means means = meansOf (table, method);
    json["summary"][method] = {{"cases", means.cases},
                               {"mean", means.mean},
                               {"within_10_mm", means.within},
                               {"converged", means.converged},
                               {"seconds", means.seconds}};
  }
  for (const CloudRow& row : table.rows)
    json["rows"].push_back ({{"case", row.name},
                             {"number", row.number},
                             {"method", row.method},
                             {"points", row.score.points},
                             {"mean", row.score.mean},
                             {"median", row.score.median},
                             {"p95", row.score.p95},
                             {"within_10_mm", row.score.within},
                             {"converged", row.converged},
                             {"seconds", row.seconds}});
  return io::jsonText (json);
}

} // namespace pcl_msf::tool
