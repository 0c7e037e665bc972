// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/input_file.h"
#include <pcl_msf/io/html_report.h>

#include <filesystem>

namespace pcl_msf::io {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/** Takes text apart, character by character. */
class CsvReader {
public:
  CsvReader (const std::string& text, const InputFile& file)
  : text_ (text), file_ (file)
  {}

  Rows
  rows ()
  {
    while (at_ < text_.size())
      if (rows_.empty() && text_[at_] == '#')
        comment();
      else
        row();
    return std::move (rows_);
  }

private:
  /** A line before the header, as pcl_msf_evaluate writes them. */
  void
  comment ()
  {
    at_ = std::min (text_.find ('\n', at_), text_.size() - 1) + 1;
  }
  void
  row ()
  {
    std::vector<std::string> cells;
    do
      cells.push_back (cell());
    while (take (','));
    take ('\r');
    take ('\n');
    if (cells.size() > 1 || !cells.front().empty())
      rows_.push_back (std::move (cells));
  }
  std::string
  cell ()
  {
    if (take ('"'))
      return quoted();
    const std::size_t end = std::min (text_.find_first_of (",\r\n", at_), text_.size());
    const std::string result = text_.substr (at_, end - at_);
    at_ = end;
    return result;
  }
  std::string
  quoted ()
  {
    std::string result;
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c != '"')
        result += c;
      else if (take ('"'))
        result += '"';
      else
        return result;
    }
    file_.fail ("line " + std::to_string (rows_.size() + 1),
                "a quote is not closed; the file is cut short or no CSV");
  }
  bool
  take (char c)
  {
    const bool there = at_ < text_.size() && text_[at_] == c;
    at_ += there ? 1 : 0;
    return there;
  }

  const std::string& text_;
  const InputFile& file_;
  std::size_t at_{0};
  Rows rows_;
};

} // namespace

HtmlTable
readCsvTable (const std::string& path)
{
  InputFile file (path);
  const std::string text = file.text();
  Rows rows = CsvReader (text, file).rows();
  if (rows.empty())
    file.fail ("header", "the file is empty; give a table of pcl_msf_evaluate");
  HtmlTable table;
  table.title = std::filesystem::path (path).filename().string();
  table.header = rows.front();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() > table.header.size())
      file.fail ("line " + std::to_string (i + 1),
                 std::to_string (rows[i].size()) + " cells, the header has " +
                     std::to_string (table.header.size()) +
                     "; the file is damaged or of another format");
    rows[i].resize (table.header.size());
    table.rows.push_back (std::move (rows[i]));
  }
  return table;
}

} // namespace pcl_msf::io
