// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "csv_file.h"

#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace pcl_msf::tool {

namespace {

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
splitQuoted (const std::string& line)
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

/** From the last comma to the first: what is left over is the first field's. */
std::vector<std::string>
splitFromEnd (const std::string& line, std::size_t most)
{
  std::vector<std::string> fields;
  std::size_t end = line.size();
  while (fields.size() + 1 < most) {
    const std::size_t comma = end > 0 ? line.rfind (',', end - 1) : std::string::npos;
    if (comma == std::string::npos)
      break;
    fields.push_back (line.substr (comma + 1, end - comma - 1));
    end = comma;
  }
  fields.push_back (line.substr (0, end));
  std::reverse (fields.begin(), fields.end());
  return fields;
}

std::string
joined (const std::vector<std::string>& fields)
{
  std::string text;
  for (const std::string& field : fields)
    text += (&field == &fields.front() ? "" : ",") + field;
  return text;
}

void
dropReturn (std::string& line) // as some editors save it
{
  if (!line.empty() && line.back() == '\r')
    line.pop_back();
}

} // namespace

std::string
headText (const CsvLayout& layout, const std::vector<std::string>& values)
{
  std::string text = layout.format + "\n";
  for (std::size_t i = 0; i < layout.notes.size(); ++i)
    text += "# " + layout.notes[i] + " " + values.at (i) + "\n";
  return text + joined (layout.columns) + "\n";
}

std::string
shortestText (double value)
{
  char text[32];
  return {text, std::to_chars (text, text + sizeof text, value).ptr};
}

std::string
lineText (const CsvLayout& layout, const std::vector<std::string>& fields)
{
  std::vector<std::string> written = fields;
  if (layout.quoted)
    std::transform (fields.begin(), fields.end(), written.begin(), quoted);
  return joined (written) + "\n";
}

std::vector<std::string>
splitLine (const CsvLayout& layout, const std::string& line)
{
  const std::size_t expected = layout.columns.size();
  std::vector<std::string> fields =
      layout.quoted ? splitQuoted (line) : splitFromEnd (line, expected);
  if (fields.size() != expected)
    throw InvalidInput ("there are " + std::to_string (fields.size()) +
                        " fields where " + std::to_string (expected) +
                        " are expected; the file is damaged or of another version");
  return fields;
}

bool
isCsv (const std::string& path, const CsvLayout& layout)
{
  try {
    io::InputFile file (path);
    file.skipByteOrderMark();
    std::string line = file.line ("first line");
    dropReturn (line);
    return line == layout.format;
  }
  catch (const IoError&) {
    return false;
  }
}

CsvReader::CsvReader (const std::string& path, const CsvLayout& layout)
: path_ (path), layout_ (layout)
{
  constexpr std::uint64_t kLargest = std::uint64_t{1} << 32;
  text_ = io::InputFile (path).text (kLargest);
  std::string line;
  if (!next (line) || line != layout.format)
    fail ("'" + layout.format +
          "' is expected; give a file that pcl_msf_evaluate wrote");
  for (const std::string& name : layout.notes) {
    const std::string begin = "# " + name + " ";
    if (!next (line) || line.rfind (begin, 0) != 0)
      fail ("'" + begin + "' is expected; give a file that pcl_msf_evaluate wrote");
    values_.push_back (line.substr (begin.size()));
  }
  if (!next (line) || line != joined (layout.columns))
    fail ("columns: other ones are expected; the file is of another version");
}

const std::string&
CsvReader::note (const std::string& name) const
{
  const auto at = std::find (layout_.notes.begin(), layout_.notes.end(), name);
  return values_.at (static_cast<std::size_t> (at - layout_.notes.begin()));
}

Shard
CsvReader::shard() const
{
  const std::string& text = note ("shard");
  const std::size_t slash = text.find ('/');
  Shard shard;
  if (slash == std::string::npos ||
      !parseNumber (text.substr (0, slash), shard.index) ||
      !parseNumber (text.substr (slash + 1), shard.count) || shard.index < 1 ||
      shard.index > shard.count)
    throw IoError (path_ + ": shard: '" + text +
                   "' is none of 1/N to N/N; the file is damaged");
  return shard;
}

std::size_t
CsvReader::count (const std::string& name) const
{
  std::size_t value = 0;
  if (!parseNumber (note (name), value))
    throw IoError (path_ + ": " + name + ": '" + note (name) +
                   "' is no number; the file is damaged");
  return value;
}

bool
CsvReader::next (std::string& line)
{
  std::size_t end = text_.find ('\n', at_);
  if (end == std::string::npos) {
    if (layout_.grows || at_ >= text_.size())
      return false;
    end = text_.size();
  }
  line = text_.substr (at_, end - at_);
  dropReturn (line);
  at_ = end + 1;
  ++line_;
  return true;
}

void
CsvReader::fail (const std::string& problem) const
{
  throw IoError (path_ + ": line " + std::to_string (line_) + ": " + problem);
}

} // namespace pcl_msf::tool
