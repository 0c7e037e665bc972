// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/json_text.h"
#include "summary.h"
#include <pcl_msf/evaluation/flow_errors.h>

namespace pcl_msf::tool {

namespace {

void
addRow (io::JsonText& json, const Row& row)
{
  json.openObject();
  json.integer ("pair", static_cast<long> (row.pair));
  json.string ("sequence", row.sequence);
  json.integer ("from", row.from);
  json.integer ("to", row.to);
  json.string ("method", row.method);
  for (const Column& c : columns())
    json.number (c.name, row.score.*c.value);
  for (const auto& [key, motion] :
       {std::pair ("motion", &row.score.motion),
        std::pair ("true_motion", &row.score.true_motion)}) {
    json.openArray (key);
    for (const double p : *motion)
      json.number ("", p);
    json.closeArray();
  }
  json.closeObject();
}

/** Mean and median of each number that the rows have. */
void
addMeans (io::JsonText& json,
          const std::vector<Row>& rows,
          const std::string& method,
          const std::string& sequence)
{
  for (const Column& c : columns()) {
    const std::vector<double> values = valuesOf (rows, method, c.value, sequence);
    if (values.empty())
      continue;
    json.openObject (c.name);
    json.integer ("rows", static_cast<long> (values.size()));
    json.number ("mean", evaluation::mean (values));
    json.number ("median", evaluation::median (values));
    json.closeObject();
  }
}

void
addSummary (io::JsonText& json, const std::vector<Row>& rows)
{
  json.openObject ("summary");
  for (const std::string& method : methodsOf (rows)) {
    json.openObject (method);
    addMeans (json, rows, method, {});
    json.closeObject();
  }
  json.closeObject();
  json.openObject ("sequences");
  for (const std::string& sequence : sequencesOf (rows)) {
    json.openObject (sequence);
    for (const std::string& method : methodsOf (rows)) {
      json.openObject (method);
      addMeans (json, rows, method, sequence);
      json.closeObject();
    }
    json.closeObject();
  }
  json.closeObject();
}

} // namespace

std::string
jsonText (const ResultFile& results)
{
  io::JsonText json;
  json.openObject();
  json.string ("version", results.version);
  json.string ("settings", results.settings);
  json.string ("shard", results.shard.text());
  json.integer ("pairs", static_cast<long> (results.pairs));
  addSummary (json, results.rows);
  json.openArray ("paths");
  for (const PathErrors& path : pathErrors (results.rows)) {
    json.openObject();
    json.string ("sequence", path.sequence);
    json.string ("method", path.method);
    json.integer ("poses", path.poses);
    json.number ("ate_m", path.ate_m);
    json.number ("rpe_m", path.rpe_m);
    json.number ("rpe_deg", path.rpe_deg);
    json.closeObject();
  }
  json.closeArray();
  json.openArray ("rows");
  for (const Row& row : results.rows)
    addRow (json, row);
  json.closeArray();
  json.closeObject();
  return json.text();
}

bool
isResultsJson (const std::string& text)
{
  const std::size_t key = text.find_first_not_of (" \n", 1);
  return text.rfind ('{', 0) == 0 && key != std::string::npos &&
         text.compare (key, 9, "\"version\"") == 0;
}

} // namespace pcl_msf::tool
