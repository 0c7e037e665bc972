// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "io/base/drawing.h"
#include "io/page/html_page.h"
#include <pcl_msf/io/html_report.h>
#include <pcl_msf/io/text_files.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;
using HtmlRow = std::vector<std::string>;

constexpr const char* kGenerator =
    "<meta name=\"generator\" content=\"pcl_msf_report\">\n";

std::string
escaped (const std::string& text)
{
  std::string result;
  for (const char c : text)
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

/** A path as a link from the page's folder. */
std::string
link (const std::string& path, const std::string& folder)
{
  const fs::path base = fs::absolute (folder.empty() ? "." : folder).lexically_normal();
  const fs::path target = fs::absolute (path).lexically_normal();
  const std::string relative = target.lexically_relative (base).generic_string();
  std::string result;
  for (const char c : relative) {
    const auto byte = static_cast<unsigned char> (c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       (c >= '0' && c <= '9') ||
                       std::string ("/._-~").find (c) != std::string::npos;
    std::array<char, 4> code{};
    std::snprintf (code.data(), code.size(), "%%%02X", unsigned{byte});
    result += plain ? std::string (1, c) : std::string (code.data());
  }
  return result;
}

bool
isNumber (const std::string& text)
{
  double value = 0.0;
  return parseNumber (text, value);
}

/** Columns in which every cell that is not empty is a number, and one is. */
std::vector<bool>
numberColumns (const HtmlTable& table)
{
  std::vector<bool> numbers (table.header.size(), false);
  for (std::size_t column = 0; column < numbers.size(); ++column) {
    bool all = true;
    bool any = false;
    for (const auto& row : table.rows) {
      const std::string& cell = row.at (column);
      any = any || isNumber (cell);
      all = all && (cell.empty() || isNumber (cell));
    }
    numbers[column] = any && all;
  }
  return numbers;
}

/** Three digits of a number are enough to look at; whole numbers and words stay. */
std::string
shown (const std::string& text)
{
  double value = 0.0;
  if (text.find_first_of (".e") == std::string::npos || !parseNumber (text, value))
    return text;
  return shortNumber (value);
}

/** The table without columns that are empty. */
HtmlTable
withoutEmptyColumns (const HtmlTable& table)
{
  HtmlTable result{table.title, {}, std::vector<HtmlRow> (table.rows.size())};
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    if (!table.rows.empty() &&
        std::all_of (table.rows.begin(), table.rows.end(), [column] (const HtmlRow& r) {
          return r.at (column).empty();
        }))
      continue;
    result.header.push_back (table.header[column]);
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      result.rows[i].push_back (table.rows[i][column]);
  }
  return result;
}

std::string
tableText (const HtmlTable& whole)
{
  const HtmlTable table = withoutEmptyColumns (whole);
  const std::vector<bool> numbers = numberColumns (table);
  const auto kind = [&numbers] (std::size_t column) {
    return numbers[column] ? " class=\"number\"" : "";
  };
  std::string text =
      "<h2>" + escaped (table.title) +
      "</h2>\n<div class=\"wide\"><table class=\"sortable\">\n<thead><tr>";
  for (std::size_t i = 0; i < table.header.size(); ++i)
    text += "<th" + std::string (kind (i)) + ">" + escaped (table.header[i]) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      text += "<td" + std::string (kind (i)) + ">" + escaped (shown (row[i])) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string
image (const HtmlPicture& picture, const std::string& folder, const std::string& kind)
{
  return "<img" + (kind.empty() ? "" : " class=\"" + kind + "\"") + " src=\"" +
         link (picture.path, folder) + "\" alt=\"" + escaped (picture.caption) +
         "\" loading=\"lazy\">";
}

std::string
comparisonText (const HtmlComparison& comparison, const std::string& folder)
{
  return "<figure class=\"comparison\"><div class=\"stack\">" +
         image (comparison.before, folder, "before") +
         image (comparison.after, folder, "after") +
         "</div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" hidden "
         "aria-label=\"compare\"><figcaption>left: " +
         escaped (comparison.before.caption) +
         ", right: " + escaped (comparison.after.caption) +
         " <button type=\"button\" hidden>flicker</button></figcaption></figure>\n";
}

std::string
entryText (const HtmlEntry& entry, const std::string& folder, std::size_t number)
{
  std::string text = "<section id=\"entry" + std::to_string (number) + "\">\n<h2>" +
                     escaped (entry.name) + "</h2>\n<div class=\"entry\">\n";
  for (const HtmlComparison& comparison : entry.comparisons)
    text += comparisonText (comparison, folder);
  if (!entry.numbers.empty()) {
    text += "<table>\n";
    for (const auto& [name, value] : entry.numbers)
      text += "<tr><th>" + escaped (name) + "</th><td class=\"number\">" +
              escaped (value) + "</td></tr>\n";
    text += "</table>\n";
  }
  text += "</div>\n<div class=\"thumbnails\">\n";
  for (const HtmlPicture& picture : entry.pictures)
    text += "<figure><a href=\"" + link (picture.path, folder) + "\">" +
            image (picture, folder, "") + "</a><figcaption>" +
            escaped (picture.caption) + "</figcaption></figure>\n";
  return text + "</div>\n</section>\n";
}

/** The numbers of all entries, a row each. */
HtmlTable
summary (const std::vector<HtmlEntry>& entries)
{
  HtmlTable table;
  table.title = "All results";
  table.header = {"result"};
  for (const HtmlEntry& entry : entries)
    for (const auto& [name, value] : entry.numbers)
      if (std::find (table.header.begin(), table.header.end(), name) ==
          table.header.end())
        table.header.push_back (name);
  for (const HtmlEntry& entry : entries) {
    std::vector<std::string> row (table.header.size());
    row[0] = entry.name;
    for (const auto& [name, value] : entry.numbers) {
      const auto at = std::find (table.header.begin() + 1, table.header.end(), name);
      row[at - table.header.begin()] = value;
    }
    table.rows.push_back (row);
  }
  return table;
}

} // namespace

std::string
htmlPage (const HtmlReport& report, const std::string& folder)
{
  std::string text =
      std::string ("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
                   "<meta charset=\"utf-8\">\n") +
      kGenerator + "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
      escaped (report.title) + "</title>\n<style>" + kPageStyle +
      "</style>\n</head>\n<body>\n<h1>" + escaped (report.title) + "</h1>\n";
  if (report.entries.size() > 1) {
    text += "<nav>";
    for (std::size_t i = 0; i < report.entries.size(); ++i)
      text += "<a href=\"#entry" + std::to_string (i) + "\">" +
              escaped (report.entries[i].name) + "</a>";
    text += "</nav>\n";
    text += tableText (summary (report.entries));
  }
  for (const HtmlTable& table : report.tables)
    text += tableText (table);
  for (std::size_t i = 0; i < report.entries.size(); ++i)
    text += entryText (report.entries[i], folder, i);
  return text + "<script>" + kPageScript + "</script>\n</body>\n</html>\n";
}

bool
isHtmlReport (const std::string& page)
{
  return page.find (kGenerator) != std::string::npos;
}

void
writeHtmlReport (const std::string& path, const HtmlReport& report)
{
  writeText (path, htmlPage (report, fs::path (path).parent_path().string()));
}

} // namespace pcl_msf::io
