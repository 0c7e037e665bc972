// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "cloud_table.h"

#include "common/command_line.h"
#include "core/base/number_text.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <utility>

namespace pcl_msf::tool {

namespace {

constexpr const char* kFormat = "# pcl_msf_evaluate, clouds without a grid, 2";
constexpr const char* kHead =
    "case,method,points,mean,median,p95,within_10_mm,converged,seconds,number";
constexpr std::size_t kNumbers = 9; // fields behind the case's name

class CloudCsvReader {
public:
  explicit CloudCsvReader (const std::string& path)
  : path_ (path), stream_ (path, std::ios::binary)
  {}

  CloudTable
  run ()
  {
    CloudTable table;
    expect (kFormat);
    table.settings = after ("# settings ");
    table.methods = splitAtCommas (after ("# methods "));
    table.shard = parseShard (after ("# shard "));
    number (after ("# cases "), table.cases);
    expect (kHead);
    std::string line;
    while (next (line))
      table.rows.push_back (row (line));
    return table;
  }

private:
  [[noreturn]] void
  fail (const std::string& what) const
  {
    throw IoError (path_ + ": line " + std::to_string (line_) + ": " + what +
                   "; the file is damaged or no table of clouds");
  }
  bool
  next (std::string& line)
  {
    ++line_;
    return static_cast<bool> (std::getline (stream_, line));
  }
  void
  expect (const std::string& text)
  {
    std::string line;
    if (!next (line) || line != text)
      fail ("'" + text + "' is expected");
  }
  std::string
  after (const std::string& begin)
  {
    std::string line;
    if (!next (line) || line.rfind (begin, 0) != 0)
      fail ("'" + begin + "' is expected");
    return line.substr (begin.size());
  }
  template <typename Number>
  void
  number (const std::string& text, Number& value) const
  {
    if (!parseNumber (text, value))
      fail ("'" + text + "' is no number");
  }
  CloudRow
  row (const std::string& line) const
  {
    std::vector<std::string> fields;
    std::size_t end = line.size();
    while (fields.size() < kNumbers) { // the name may hold commas
      const std::size_t comma = end > 0 ? line.rfind (',', end - 1) : std::string::npos;
      if (comma == std::string::npos)
        fail (std::to_string (kNumbers + 1) + " fields are expected");
      fields.insert (fields.begin(), line.substr (comma + 1, end - comma - 1));
      end = comma;
    }
    CloudRow row{line.substr (0, end), fields[0], {}, fields[6] == "1", 0.0, 0};
    number (fields[1], row.score.points);
    number (fields[2], row.score.mean);
    number (fields[3], row.score.median);
    number (fields[4], row.score.p95);
    number (fields[5], row.score.within);
    number (fields[7], row.seconds);
    number (fields[8], row.number);
    return row;
  }

  std::string path_;
  std::ifstream stream_;
  int line_{0};
};

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
  std::string text =
      kFormat + std::string ("\n# settings ") + table.settings + "\n# methods ";
  for (std::size_t i = 0; i < table.methods.size(); ++i)
    text += (i == 0 ? "" : ",") + table.methods[i];
  text += "\n# shard " + table.shard.text() + "\n# cases " +
          std::to_string (table.cases) + "\n" + kHead + "\n";
  for (const CloudRow& row : table.rows)
    text += row.name + "," + row.method + "," + std::to_string (row.score.points) +
            "," + fixedText (row.score.mean, 6) + "," +
            fixedText (row.score.median, 6) + "," + fixedText (row.score.p95, 6) + "," +
            fixedText (row.score.within, 4) + "," + (row.converged ? "1" : "0") + "," +
            fixedText (row.seconds, 3) + "," + std::to_string (row.number) + "\n";
  return text;
}

bool
isCloudCsv (const std::string& path)
{
  std::ifstream stream (path, std::ios::binary);
  std::string line;
  return std::getline (stream, line) && line == kFormat;
}

CloudTable
readCloudCsv (const std::string& path)
{
  return CloudCsvReader (path).run();
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
