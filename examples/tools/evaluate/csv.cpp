// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "csv.h"

#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/text_files.h>

#include <charconv>
#include <cmath>
#include <sstream>

namespace pcl_msf::tool {

namespace {

constexpr const char* kFormat = "# pcl_msf_evaluate results 1";

std::string
numberText (double value)
{
  if (!std::isfinite (value))
    return {};
  char text[32];
  return {text, std::to_chars (text, text + sizeof text, value).ptr};
}

std::string
quoted (const std::string& text)
{
  if (text.find_first_of (",\"") == std::string::npos)
    return text;
  std::string result = "\"";
  for (const char c : text)
    if (c == '"')
      result += "\"\"";
    else
      result += c;
  return result + "\"";
}

std::vector<std::string>
split (const std::string& line)
{
  std::vector<std::string> fields (1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && inside && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[i++];
    else if (line[i] == '"')
      inside = !inside;
    else if (line[i] == ',' && !inside)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  return fields;
}

/** Names of all fields of a row. */
const std::vector<std::string>&
fieldNames ()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"pair", "dataset", "sequence", "from", "to", "method"};
    for (const Column& c : columns())
      all.push_back (c.name);
    for (const char* motion : {"motion_", "true_motion_"})
      for (const char* part : {"ax", "ay", "az", "tx", "ty", "tz"})
        all.push_back (std::string (motion) + part);
    return all;
  }();
  return names;
}

std::string
namesText ()
{
  std::string text;
  for (const std::string& name : fieldNames())
    text += (text.empty() ? "" : ",") + name;
  return text;
}

template <typename Number>
void
readField (const std::string& text, const std::string& name, Number& value)
{
  if (!parseNumber (text, value))
    throw InvalidInput (name + ": '" + text + "' is no number; the file is damaged");
}

} // namespace

std::string
headText (const ResultFile& file)
{
  return std::string (kFormat) + "\n# version " + file.version + "\n# settings " +
         file.settings + "\n# shard " + file.shard.text() + "\n# pairs " +
         std::to_string (file.pairs) + "\n" + namesText() + "\n";
}

std::string
rowText (const Row& row)
{
  std::string text = std::to_string (row.pair) + "," + quoted (row.dataset) + "," +
                     quoted (row.sequence) + "," + std::to_string (row.from) + "," +
                     std::to_string (row.to) + "," + quoted (row.method);
  for (const Column& c : columns())
    text += "," + numberText (row.score.*c.value);
  for (const double p : row.score.motion)
    text += "," + numberText (p);
  for (const double p : row.score.true_motion)
    text += "," + numberText (p);
  return text + "\n";
}

Row
parseRow (const std::string& line)
{
  const std::vector<std::string> fields = split (line);
  const std::vector<std::string>& names = fieldNames();
  if (fields.size() != names.size())
    throw InvalidInput ("there are " + std::to_string (fields.size()) +
                        " fields where " + std::to_string (names.size()) +
                        " are expected; the file is damaged or of another version");
  Row row;
  readField (fields[0], names[0], row.pair);
  row.dataset = fields[1];
  row.sequence = fields[2];
  readField (fields[3], names[3], row.from);
  readField (fields[4], names[4], row.to);
  row.method = fields[5];
  std::size_t at = 6;
  const auto next = [&] (double& value) {
    if (!fields[at].empty())
      readField (fields[at], names[at], value);
    ++at;
  };
  for (const Column& c : columns())
    next (row.score.*c.value);
  for (double& p : row.score.motion)
    next (p);
  for (double& p : row.score.true_motion)
    next (p);
  return row;
}

namespace {

/** Reads the lines of a file one after the other and tells where it is. */
class LineReader {
public:
  explicit LineReader (const std::string& path) : path_ (path)
  {
    constexpr std::uint64_t kLargest = std::uint64_t{1} << 32;
    text_ = io::InputFile (path).text (kLargest);
  }

  /** False at the end, and for a last line without an end. */
  bool
  next (std::string& line)
  {
    const std::size_t end = text_.find ('\n', at_);
    if (end == std::string::npos)
      return false;
    line = text_.substr (at_, end - at_);
    if (!line.empty() && line.back() == '\r') // as some editors save it
      line.pop_back();
    at_ = end + 1;
    ++number_;
    return true;
  }

  /** The rest of a line that must begin so. */
  std::string
  after (const std::string& begin)
  {
    std::string line;
    if (!next (line) || line.rfind (begin, 0) != 0)
      fail ("'" + begin + "' is expected; give a file that pcl_msf_evaluate wrote");
    return line.substr (begin.size());
  }

  [[noreturn]] void
  fail (const std::string& problem) const
  {
    throw IoError (path_ + ": line " + std::to_string (number_) + ": " + problem);
  }

private:
  std::string path_;
  std::string text_;
  std::size_t at_{0};
  int number_{0};
};

void
readHead (LineReader& reader, ResultFile& file)
{
  reader.after (kFormat);
  file.version = reader.after ("# version ");
  file.settings = reader.after ("# settings ");
  const std::string shard = reader.after ("# shard ");
  const std::size_t slash = std::min (shard.find ('/'), shard.size() - 1);
  if (!parseNumber (shard.substr (0, slash), file.shard.index) ||
      !parseNumber (shard.substr (slash + 1), file.shard.count) ||
      file.shard.index < 1 || file.shard.index > file.shard.count)
    reader.fail ("shard: '" + shard + "' is none of 1/N to N/N; the file is damaged");
  if (!parseNumber (reader.after ("# pairs "), file.pairs))
    reader.fail ("pairs: no number; the file is damaged");
  if (!reader.after (namesText()).empty())
    reader.fail ("columns: other columns; the file is of another version");
}

} // namespace

ResultFile
readResults (const std::string& path)
{
  LineReader reader (path);
  ResultFile file;
  readHead (reader, file);
  for (std::string line; reader.next (line);)
    try {
      file.rows.push_back (parseRow (line));
    }
    catch (const InvalidInput& e) {
      reader.fail (e.what());
    }
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
