// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "cloud_run.h"

#include "common/interruption.h"
#include "common/table_text.h"
#include "common/tool_main.h"
#include "core/base/number_text.h"
#include "core/base/order_statistics.h"
#include "run_progress.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/text_files.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

namespace pcl_msf::tool {

namespace {

constexpr double kClose = 0.01; // metres
constexpr const char* kHead =
    "case,method,points,mean,median,p95,within_10_mm,converged,seconds\n";

struct CloudRow {
  std::string name;
  std::string method;
  CloudScore score;
  bool converged;
  double seconds;
};

std::string
csvText (const std::vector<CloudRow>& rows)
{
  std::string text = kHead;
  for (const CloudRow& row : rows)
    text += row.name + "," + row.method + "," + std::to_string (row.score.points) +
            "," + fixedText (row.score.mean, 6) + "," +
            fixedText (row.score.median, 6) + "," + fixedText (row.score.p95, 6) + "," +
            fixedText (row.score.within, 4) + "," + (row.converged ? "1" : "0") + "," +
            fixedText (row.seconds, 3) + "\n";
  return text;
}

std::string
tableText (const std::vector<CloudRow>& rows)
{
  TableText table ({"case",
                    "method",
                    "mean mm",
                    "median mm",
                    "95 % mm",
                    "< 10 mm %",
                    "converged",
                    "s"});
  for (const CloudRow& row : rows)
    table.add ({row.name,
                row.method,
                cell (1e3 * row.score.mean, 2),
                cell (1e3 * row.score.median, 2),
                cell (1e3 * row.score.p95, 2),
                cell (100.0 * row.score.within, 1),
                row.converged ? "yes" : "no",
                cell (row.seconds, 2)});
  return table.text();
}

/** Means over the cases that all methods have answered. */
std::string
summaryText (const std::vector<CloudRow>& rows, const std::vector<std::string>& methods)
{
  std::map<std::string, std::size_t> answers;
  for (const CloudRow& row : rows)
    ++answers[row.name];
  TableText table ({"method", "cases", "mean mm", "< 10 mm %", "converged", "s"});
  for (const std::string& method : methods) {
    CloudScore sum{};
    int cases = 0;
    int converged = 0;
    double seconds = 0.0;
    for (const CloudRow& row : rows)
      if (row.method == method && answers[row.name] == methods.size()) {
        sum.mean += row.score.mean;
        sum.within += row.score.within;
        seconds += row.seconds;
        converged += row.converged ? 1 : 0;
        ++cases;
      }
    const double n = cases > 0 ? cases : std::nan ("");
    table.add ({method,
                std::to_string (cases),
                cell (1e3 * sum.mean / n, 2),
                cell (100.0 * sum.within / n, 1),
                std::to_string (converged),
                cell (seconds / n, 2)});
  }
  return table.text();
}

/** Another program's file is not to be written over. */
void
requireOwn (const std::string& csv)
{
  std::ifstream stream (csv, std::ios::binary);
  std::string line;
  if (stream && std::getline (stream, line) && line + "\n" != kHead)
    throw UsageError ("--csv: '" + csv +
                      "' is there and no table of clouds; give another name");
}

} // namespace

CloudScore
scoreClouds (const CloudCase& data, const std::vector<Eigen::Vector3f>& warped)
{
  std::vector<double> errors;
  double sum = 0.0;
  int close = 0;
  for (std::size_t i = 0; i < data.truth.size(); ++i) {
    if (!data.truth[i].allFinite() || !data.source[i].allFinite())
      continue;
    const Eigen::Vector3f& p = warped[i].allFinite() ? warped[i] : data.source[i];
    errors.push_back ((p - data.truth[i]).cast<double>().norm());
    sum += errors.back();
    close += errors.back() < kClose ? 1 : 0;
  }
  const double none = std::nan ("");
  if (errors.empty())
    return {none, none, none, none, 0};
  const std::size_t n = errors.size();
  const double mean = sum / static_cast<double> (n);
  const double within = close / static_cast<double> (n);
  const double middle = nthSmallest (errors, (n - 1) / 2);
  const double high = nthSmallest (errors, 95 * (n - 1) / 100);
  return {mean, middle, high, within, static_cast<int> (n)};
}

int
evaluateClouds (const EvaluateOptions& options)
{
  requireOwn (options.csv);
  const std::vector<std::string> names = listCloudCases (options);
  std::vector<CloudRow> rows;
  RunProgress progress (names.size(), !options.quiet);
  bool failed = false;
  for (const std::string& name : names) {
    try {
      const CloudCase data = loadCloudCase (options, name);
      for (const std::string& method : options.methods) {
        throwIfInterrupted();
        const CloudEstimate estimate = runCloudMethod (method, data, options.threads);
        rows.push_back ({name,
                         method,
                         scoreClouds (data, estimate.warped),
                         estimate.converged,
                         estimate.seconds});
      }
    }
    catch (const InvalidInput& error) {
      failed = true;
      progress.clear();
      complain ("pcl_msf_evaluate", name + ": " + error.what());
    }
    progress.step (name);
  }
  if (!options.csv.empty())
    io::writeText (options.csv, csvText (rows));
  std::fputs ((tableText (rows) + "\n" + summaryText (rows, options.methods)).c_str(),
              stdout);
  return failed ? 1 : 0;
}

} // namespace pcl_msf::tool
