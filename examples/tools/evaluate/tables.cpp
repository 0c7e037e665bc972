// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "tables.h"

#include "common/table_text.h"
#include "summary.h"
#include <pcl_msf/evaluation/flow_errors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace pcl_msf::tool {

namespace {

constexpr std::size_t kMostLines = 60; // then sequences in place of pairs

/** What a table of methods shows. */
struct Shown {
  const char* title;
  const char* column;
  double scale; ///< multiplies what is printed, e.g. 1000 for m as mm
  int decimals;
};

constexpr Shown kWithTruth[] = {
    {"Average end-point error, px, points seen in both frames", "epe_visible", 1.0, 3},
    {"Average 3D end-point error, mm, points seen in both frames",
     "epe3d_visible",
     1000.0,
     2}};
constexpr Shown kWithoutTruth[] = {
    {"Photometric residual, mean, grey levels of 255, where the first method that "
     "reports visibility sees points",
     "photo_mean",
     1.0,
     2},
    {"Photometric residual, median, there", "photo_median", 1.0, 2},
    {"Depth residual, median, mm, there; flow lifted by depth has none",
     "depth_median",
     1000.0,
     1}};

/** A line per pair, a column per method, the least in bold; mean and median. */
std::string
methodTable (const std::vector<Row>& rows, const Shown& shown)
{
  double Score::*const value = column (shown.column).value;
  const std::vector<std::string> methods = methodsOf (rows);
  std::map<std::size_t, std::map<std::string, double>> numbers;
  for (const Row& row : rows)
    if (std::isfinite (row.score.*value))
      numbers[row.pair][row.method] = shown.scale * row.score.*value;
  if (numbers.empty())
    return {};
  std::map<std::size_t, std::string> names = pairNames (rows);
  TableText::Line head{"pair"}, means{"mean"}, medians{"median"};
  head.insert (head.end(), methods.begin(), methods.end());
  TableText table (head);
  for (const auto& [pair, of] : numbers) {
    double best = std::nan ("");
    for (const auto& [method, number] : of)
      best = std::fmin (best, number);
    TableText::Line line{names[pair]};
    for (const std::string& method : methods) {
      const auto found = of.find (method);
      const double number = found == of.end() ? std::nan ("") : found->second;
      const std::string text = cell (number, shown.decimals);
      line.push_back (text == cell (best, shown.decimals) ? "**" + text + "**" : text);
    }
    table.add (line);
  }
  for (const std::string& method : methods) {
    const std::vector<double> values = valuesOf (rows, method, value);
    means.push_back (cell (shown.scale * evaluation::mean (values), shown.decimals));
    medians.push_back (
        cell (shown.scale * evaluation::median (values), shown.decimals));
  }
  table.add (means);
  table.add (medians);
  return std::string (shown.title) + "\n\n" + table.text() + "\n";
}

/** A line per number, a column per method, means over the pairs. */
std::string
summaryTable (const std::vector<Row>& rows)
{
  const std::vector<std::string> methods = methodsOf (rows);
  TableText::Line head{"mean over pairs"};
  head.insert (head.end(), methods.begin(), methods.end());
  TableText table (head);
  for (const Column& c : columns()) {
    TableText::Line line{c.name};
    for (const std::string& method : methods)
      line.push_back (
          cell (evaluation::mean (valuesOf (rows, method, c.value)), c.decimals));
    if (std::any_of (methods.begin(), methods.end(), [&] (const std::string& m) {
          return !valuesOf (rows, m, c.value).empty();
        }))
      table.add (line);
  }
  return "Means over the pairs where a method has the number\n\n" + table.text() + "\n";
}

std::string
pathTable (const std::vector<Row>& rows)
{
  TableText table ({"camera path", "method", "poses", "ATE mm", "RPE mm", "RPE deg"});
  for (const PathErrors& path : pathErrors (rows))
    table.add ({path.sequence,
                path.method,
                std::to_string (path.poses),
                cell (1000.0 * path.ate_m, 2),
                cell (1000.0 * path.rpe_m, 2),
                cell (path.rpe_deg, 3)});
  if (table.empty())
    return {};
  return "Camera paths by the dominant motion, root mean squares\n\n" + table.text() +
         "\n";
}

} // namespace

std::string
allTables (const std::vector<Row>& all)
{
  std::set<std::size_t> pairs;
  for (const Row& row : all)
    pairs.insert (row.pair);
  const bool brief = pairs.size() > kMostLines;
  const std::vector<Row> rows = brief ? meansPerSequence (all) : all;
  std::string text =
      brief ? std::string ("Lines are means over a sequence's pairs.\n\n") : "";
  for (const Shown& shown : kWithTruth)
    text += methodTable (rows, shown);
  const bool some_unknown = std::any_of (rows.begin(), rows.end(), [] (const Row& row) {
    return std::isnan (row.score.epe_visible);
  });
  if (some_unknown)
    for (const Shown& shown : kWithoutTruth)
      text += methodTable (rows, shown);
  return text + detailTables (rows, methodsOf (rows).at (0)) + pathTable (all) +
         summaryTable (all) + sintelTable (all) + ablationTable (all);
}

} // namespace pcl_msf::tool
