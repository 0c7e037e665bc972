// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "cloud_table.h"

#include "common/command_line.h"
#include "csv_table.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pcl_msf::tool {

namespace {

struct CloudFields {
  template <typename AnyRow, typename Field>
  void
  operator() (AnyRow& row, const Field& field) const
  {
    field ("case", row.name);
    field ("method", row.method);
    field ("points", row.score.points);
    field ("mean", row.score.mean, 6);
    field ("median", row.score.median, 6);
    field ("p95", row.score.p95, 6);
    field ("within_10_mm", row.score.within, 4);
    field ("converged", row.converged);
    field ("seconds", row.seconds, 3);
    field ("number", row.number);
  }
};

const CsvTable<CloudRow, CloudFields>&
csv ()
{
  static const CsvTable<CloudRow, CloudFields> clouds (
      {"# pcl_msf_evaluate, clouds without a grid, 2",
       {"settings", "methods", "shard", "cases"},
       {},
       false,
       false});
  return clouds;
}

/** By case, then as the methods are in order. */
void
sortRows (CloudTable& table)
{
  const auto place = [&table] (const CloudRow& row) {
    const auto at = std::find (table.methods.begin(), table.methods.end(), row.method);
    return std::make_pair (row.number, at - table.methods.begin());
  };
  std::stable_sort (table.rows.begin(),
                    table.rows.end(),
                    [&place] (const CloudRow& a, const CloudRow& b) {
                      return place (a) < place (b);
                    });
}

} // namespace

std::string
csvText (const CloudTable& table)
{
  std::string methods;
  for (std::size_t i = 0; i < table.methods.size(); ++i)
    methods += (i == 0 ? "" : ",") + table.methods[i];
  std::string text = headText (
      csv().layout(),
      {table.settings, methods, table.shard.text(), std::to_string (table.cases)});
  for (const CloudRow& row : table.rows)
    text += csv().rowText (row);
  return text;
}

bool
isCloudCsv (const std::string& path)
{
  return isCsv (path, csv().layout());
}

CloudTable
readCloudCsv (const std::string& path)
{
  CsvReader reader (path, csv().layout());
  CloudTable table{reader.note ("settings"),
                   splitAtCommas (reader.note ("methods")),
                   static_cast<int> (reader.count ("cases")),
                   reader.shard(),
                   {}};
  table.rows = csv().readRows (reader);
  return table;
}

CloudTable
mergeClouds (const std::vector<std::string>& paths)
{
  CloudTable merged;
  std::set<std::pair<int, std::string>> seen;
  for (const std::string& path : paths) {
    CloudTable table = readCloudCsv (path);
    if (&path == &paths.front())
      merged = {table.settings, table.methods, table.cases, {}, {}};
    if (table.settings != merged.settings || table.methods != merged.methods ||
        table.cases != merged.cases)
      throw UsageError (paths.front() + " and " + path + ": of different runs (" +
                        merged.settings + " and " + table.settings +
                        "); give the shards of one");
    for (CloudRow& row : table.rows) {
      if (!seen.insert ({row.number, row.method}).second)
        throw UsageError (path + ": case " + row.name +
                          " is in another file, too; "
                          "give each shard once");
      merged.rows.push_back (std::move (row));
    }
  }
  sortRows (merged);
  return merged;
}

std::string
missingCases (const CloudTable& table)
{
  std::vector<std::size_t> answers (static_cast<std::size_t> (table.cases), 0);
  for (const CloudRow& row : table.rows)
    if (row.number >= 0 && row.number < table.cases)
      ++answers[static_cast<std::size_t> (row.number)];
  std::string text;
  for (std::size_t k = 0; k < answers.size(); ++k)
    if (answers[k] < table.methods.size())
      text += (text.empty() ? "" : ", ") + std::to_string (k + 1);
  return text;
}

} // namespace pcl_msf::tool
