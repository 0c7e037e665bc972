// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/json.h"

#include "summary.h"
#include <pcl_msf/evaluation/flow_errors.h>

namespace pcl_msf::tool {

namespace {

io::Json
rowOf (const Row& row)
{
  io::Json json{{"pair", row.pair},
                {"sequence", row.sequence},
                {"from", row.from},
                {"to", row.to},
                {"method", row.method}};
  for (const Column& c : columns())
    json[c.name] = row.score.*c.value;
  json["motion"] = row.score.motion;
  json["true_motion"] = row.score.true_motion;
  return json;
}

/** Mean and median of each number that the rows have. */
io::Json
meansOf (const std::vector<Row>& rows,
         const std::string& method,
         const std::string& sequence)
{
  io::Json json = io::Json::object();
  for (const Column& c : columns()) {
    const std::vector<double> values = valuesOf (rows, method, c.value, sequence);
    if (!values.empty())
      json[c.name] = {{"rows", values.size()},
                      {"mean", evaluation::mean (values)},
                      {"median", evaluation::median (values)}};
  }
  return json;
}

} // namespace

std::string
jsonText (const ResultFile& results)
{
  io::Json json{{"version", results.version},
                {"settings", results.settings},
                {"shard", results.shard.text()},
                {"pairs", results.pairs},
                {"summary", io::Json::object()},
                {"sequences", io::Json::object()},
                {"paths", io::Json::array()},
                {"rows", io::Json::array()}};
  for (const std::string& method : methodsOf (results.rows))
    json["summary"][method] = meansOf (results.rows, method, {});
  for (const std::string& sequence : sequencesOf (results.rows))
    for (const std::string& method : methodsOf (results.rows))
      json["sequences"][sequence][method] = meansOf (results.rows, method, sequence);
  for (const PathErrors& path : pathErrors (results.rows))
    json["paths"].push_back ({{"sequence", path.sequence},
                              {"method", path.method},
                              {"poses", path.poses},
                              {"ate_m", path.ate_m},
                              {"rpe_m", path.rpe_m},
                              {"rpe_deg", path.rpe_deg}});
  for (const Row& row : results.rows)
    json["rows"].push_back (rowOf (row));
  return io::jsonText (json);
}

bool
isResultsJson (const std::string& text)
{
  const std::size_t key = text.find_first_not_of (" \n", 1);
  return text.rfind ('{', 0) == 0 && key != std::string::npos &&
         text.compare (key, 9, "\"version\"") == 0;
}

} // namespace pcl_msf::tool
