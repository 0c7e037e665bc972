// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "pair_table.h"

#include "csv_table.h"
#include <pcl_msf/io/text_files.h>

#include <array>

namespace pcl_msf::tool {

namespace {

struct PairFields {
  template <typename AnyRow, typename Field>
  void
  operator() (AnyRow& row, const Field& field) const
  {
    field ("pair", row.pair);
    field ("dataset", row.dataset);
    field ("sequence", row.sequence);
    field ("from", row.from);
    field ("to", row.to);
    field ("method", row.method);
    for (const Column& c : columns())
      field (c.name, row.score.*c.value);
    const std::array<const char*, 6> parts{"ax", "ay", "az", "tx", "ty", "tz"};
    for (std::size_t i = 0; i < parts.size(); ++i)
      field (std::string ("motion_") + parts[i], row.score.motion[i]);
    for (std::size_t i = 0; i < parts.size(); ++i)
      field (std::string ("true_motion_") + parts[i], row.score.true_motion[i]);
  }
};

const CsvTable<Row, PairFields>&
table ()
{
  static const CsvTable<Row, PairFields> pairs (
      {"# pcl_msf_evaluate results 1",
       {"version", "settings", "shard", "pairs"},
       {},
       true,
       true});
  return pairs;
}

} // namespace

std::string
headText (const ResultFile& file)
{
  return headText (
      table().layout(),
      {file.version, file.settings, file.shard.text(), std::to_string (file.pairs)});
}

std::string
rowText (const Row& row)
{
  return table().rowText (row);
}

Row
parseRow (const std::string& line)
{
  return table().parseRow (line);
}

ResultFile
readResults (const std::string& path)
{
  CsvReader reader (path, table().layout());
  ResultFile file{reader.note ("version"),
                  reader.note ("settings"),
                  reader.shard(),
                  reader.count ("pairs"),
                  {}};
  file.rows = table().readRows (reader);
  return file;
}

void
writeResults (const std::string& path, const ResultFile& file)
{
  std::string text = headText (file);
  for (const Row& row : file.rows)
    text += rowText (row);
  io::writeText (path, text);
}

} // namespace pcl_msf::tool
