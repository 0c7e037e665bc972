// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "cloud_run.h"

#include "cloud_table.h"
#include "common/interruption.h"
#include "common/tool_main.h"
#include "core/base/order_statistics.h"
#include "core/base/tuning/tuning.h"
#include "run_progress.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/text_files.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace pcl_msf::tool {

namespace {

constexpr double kClose = 0.01; // metres
/** Another program's file is not to be written over. */
void
requireOwn (const std::string& csv)
{
  if (std::ifstream (csv) && !isCloudCsv (csv))
    throw UsageError ("--csv: '" + csv +
                      "' is there and no table of clouds; give another name");
}

std::string
settingsOf (const EvaluateOptions& options)
{
  std::string text = options.dataset;
  if (options.dataset == kBodies)
    text += " seed=" + std::to_string (options.generated.seed) +
            " noise_seeds=" + std::to_string (options.generated.noise_seeds);
  for (const auto& [name, value] : changedTuning())
    text += " " + name + "=" + value;
  return text;
}

/** A case by all methods. */
void
score (const EvaluateOptions& options,
       const std::string& name,
       int number,
       CloudTable& table)
{
  const CloudCase data = loadCloudCase (options, name);
  for (const std::string& method : options.methods) {
    throwIfInterrupted();
    const CloudEstimate estimate = runCloudMethod (method, data, options.threads);
    table.rows.push_back ({name,
                           method,
                           scoreClouds (data, estimate.warped),
                           estimate.converged,
                           estimate.seconds,
                           number});
  }
}

void
write (const CloudTable& table, const EvaluateOptions& options)
{
  if (!options.csv.empty())
    io::writeText (options.csv, csvText (table));
  if (!options.json.empty())
    io::writeText (options.json, jsonText (table));
  std::fputs (tablesText (table).c_str(), stdout);
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
  const auto cases = static_cast<int> (names.size());
  CloudTable table{settingsOf (options), options.methods, cases, options.shard, {}};
  std::size_t todo = 0;
  for (int k = 0; k < cases; ++k)
    todo += options.shard.has (k) ? 1 : 0;
  RunProgress progress (todo, !options.quiet);
  bool failed = false;
  for (int k = 0; k < cases; ++k) {
    if (!options.shard.has (k))
      continue;
    try {
      score (options, names[k], k, table);
    }
    catch (const InvalidInput& error) {
      failed = true;
      progress.clear();
      complain ("pcl_msf_evaluate", names[k] + ": " + error.what());
    }
    progress.step (names[k]);
  }
  write (table, options);
  return failed ? 1 : 0;
}

int
mergeCloudShards (const EvaluateOptions& options)
{
  requireOwn (options.csv);
  const CloudTable table = mergeClouds (options.merged);
  write (table, options);
  const std::string missing = missingCases (table);
  if (missing.empty())
    return 0;
  complain ("pcl_msf_evaluate",
            "missing: case " + missing + " of " + std::to_string (table.cases) +
                "; run their shards again");
  return 1;
}

} // namespace pcl_msf::tool
