// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "tables.h"

#include <pcl_msf/evaluation/flow_errors.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace pcl_msf::tool {

namespace {

using Line = std::vector<std::string>;

/** A Markdown table whose columns are aligned in the text, too. */
class Table {
public:
  explicit Table (Line head) : lines_ (1, std::move (head)) {}

  void
  add (Line line)
  {
    lines_.push_back (std::move (line));
  }

  std::string
  text () const
  {
    std::vector<std::size_t> widths (lines_[0].size(), 3);
    for (const Line& line : lines_)
      for (std::size_t i = 0; i < line.size(); ++i)
        widths[i] = std::max (widths[i], line[i].size());
    std::string result;
    for (std::size_t n = 0; n < lines_.size(); ++n) {
      result += "|";
      for (std::size_t i = 0; i < widths.size(); ++i) {
        const std::string fill (widths[i] - lines_[n][i].size(), ' ');
        result += i == 0 ? " " + lines_[n][i] + fill : " " + fill + lines_[n][i];
        result += " |";
      }
      result += "\n";
      if (n > 0)
        continue;
      for (std::size_t i = 0; i < widths.size(); ++i)
        result += (i == 0 ? "|" : "") +
                  std::string (widths[i] + (i == 0 ? 2 : 1), '-') +
                  (i == 0 ? "|" : ":|");
      result += "\n";
    }
    return result;
  }

private:
  std::vector<Line> lines_;
};

std::string
cell (double value, int decimals)
{
  if (!std::isfinite (value))
    return "-";
  char text[64];
  std::snprintf (text, sizeof text, "%.*f", decimals, value);
  return text;
}

using PairKey = std::pair<std::string, std::pair<int, int>>;

PairKey
keyOf (const Row& row)
{
  return {row.sequence, {row.from, row.to}};
}

/** Name of a pair: the sequence, with frames unless it has this pair only. */
std::vector<std::pair<PairKey, std::string>>
pairsOf (const std::vector<Row>& rows)
{
  std::vector<std::pair<PairKey, std::string>> pairs;
  std::map<std::string, int> count;
  std::map<PairKey, bool> known;
  for (const Row& row : rows)
    if (!std::exchange (known[keyOf (row)], true)) {
      pairs.emplace_back (keyOf (row), row.sequence);
      ++count[row.sequence];
    }
  for (auto& [key, name] : pairs)
    if (count[key.first] > 1)
      name += " " + std::to_string (key.second.first) + "-" +
              std::to_string (key.second.second);
  return pairs;
}

std::vector<double>
known (std::vector<double> values)
{
  values.erase (std::remove_if (values.begin(),
                                values.end(),
                                [] (double v) { return !std::isfinite (v); }),
                values.end());
  return values;
}

std::vector<double>
valuesOf (const std::vector<Row>& rows, const std::string& method, double Score::*value)
{
  std::vector<double> values;
  for (const Row& row : rows)
    if (row.method == method)
      values.push_back (row.score.*value);
  return known (std::move (values));
}

} // namespace

std::vector<std::string>
methodsOf (const std::vector<Row>& rows)
{
  std::vector<std::string> methods;
  for (const Row& row : rows)
    if (std::find (methods.begin(), methods.end(), row.method) == methods.end())
      methods.push_back (row.method);
  return methods;
}

std::string
methodTable (const std::vector<Row>& rows,
             const std::string& title,
             const std::string& name,
             double scale,
             int decimals)
{
  double Score::*const value = column (name).value;
  const std::vector<std::string> methods = methodsOf (rows);
  std::map<PairKey, std::map<std::string, double>> table;
  bool any = false;
  for (const Row& row : rows) {
    table[keyOf (row)][row.method] = scale * row.score.*value;
    any = any || std::isfinite (row.score.*value);
  }
  if (!any)
    return {};
  Line head{"pair"};
  head.insert (head.end(), methods.begin(), methods.end());
  Table text (head);
  for (const auto& [key, pair] : pairsOf (rows)) {
    std::map<std::string, double>& values = table[key];
    double best = std::nan ("");
    for (const auto& [method, v] : values)
      best = std::fmin (best, v);
    if (!std::isfinite (best))
      continue;
    Line line{pair};
    for (const std::string& method : methods) {
      const double v = values.count (method) ? values[method] : std::nan ("");
      const std::string number = cell (v, decimals);
      line.push_back (v == best ? "**" + number + "**" : number);
    }
    text.add (line);
  }
  Line means{"mean"}, medians{"median"};
  for (const std::string& method : methods) {
    const std::vector<double> values = valuesOf (rows, method, value);
    means.push_back (cell (scale * evaluation::mean (values), decimals));
    medians.push_back (cell (scale * evaluation::median (values), decimals));
  }
  text.add (means);
  text.add (medians);
  return title + "\n\n" + text.text() + "\n";
}

std::string
detailTable (const std::vector<Row>& rows, const std::string& method)
{
  std::vector<Column> shown;
  for (const Column& c : columns())
    if (!valuesOf (rows, method, c.value).empty())
      shown.push_back (c);
  Line head{"pair"};
  for (const Column& c : shown)
    head.push_back (c.name);
  Table text (head);
  std::map<PairKey, std::string> names;
  for (const auto& [key, name] : pairsOf (rows))
    names[key] = name;
  for (const Row& row : rows) {
    if (row.method != method)
      continue;
    Line line{names[keyOf (row)]};
    for (const Column& c : shown)
      line.push_back (cell (row.score.*c.value, c.decimals));
    text.add (line);
  }
  return "All numbers of " + method + " (see --help for the columns)\n\n" +
         text.text() + "\n";
}

std::string
summaryTable (const std::vector<Row>& rows)
{
  const std::vector<std::string> methods = methodsOf (rows);
  std::vector<Column> shown;
  for (const Column& c : columns())
    if (std::any_of (methods.begin(), methods.end(), [&] (const std::string& m) {
          return !valuesOf (rows, m, c.value).empty();
        }))
      shown.push_back (c);
  Line head{"mean over pairs"};
  head.insert (head.end(), methods.begin(), methods.end());
  Table text (head);
  for (const Column& c : shown) {
    Line line{c.name};
    for (const std::string& method : methods)
      line.push_back (
          cell (evaluation::mean (valuesOf (rows, method, c.value)), c.decimals));
    text.add (line);
  }
  return "Means over the pairs where a method has the number\n\n" + text.text() + "\n";
}

std::string
allTables (const std::vector<Row>& rows)
{
  std::string text =
      methodTable (rows,
                   "Average end-point error, px, points seen in both frames",
                   "epe_visible",
                   1.0,
                   3);
  text += methodTable (rows,
                       "Average 3D end-point error, mm, points seen in both frames",
                       "epe3d_visible",
                       1000.0,
                       2);
  if (text.empty())
    text = methodTable (rows,
                        "Photometric residual, mean, grey levels of 255, where the "
                        "method sees points",
                        "photo_mean",
                        1.0,
                        2) +
           methodTable (
               rows, "Depth residual, median, mm, there", "depth_median", 1000.0, 1);
  text += detailTable (rows, methodsOf (rows).at (0));
  text += summaryTable (rows);
  return text;
}

} // namespace pcl_msf::tool
