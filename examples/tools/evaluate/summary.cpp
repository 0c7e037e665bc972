// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "summary.h"

#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/evaluation/trajectory_errors.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::tool {

namespace {

std::vector<std::string>
distinct (const std::vector<Row>& rows, std::string Row::*field)
{
  std::vector<std::string> values;
  for (const Row& row : rows)
    if (std::find (values.begin(), values.end(), row.*field) == values.end())
      values.push_back (row.*field);
  return values;
}

bool
isKnown (const std::array<double, 6>& motion)
{
  return std::all_of (
      motion.begin(), motion.end(), [] (double p) { return std::isfinite (p); });
}

/** The longest run from the first pair on in which each begins where the last ended. */
PathErrors
pathOf (const std::vector<Row>& rows,
        const std::string& sequence,
        const std::string& method)
{
  std::vector<RigidPose> motions, truth;
  int at = -1;
  for (const Row& row : rows) {
    if (row.sequence != sequence || row.method != method)
      continue;
    if (!isKnown (row.score.motion) || !isKnown (row.score.true_motion) ||
        (at >= 0 && row.from != at))
      break;
    at = row.to;
    motions.push_back ({row.score.motion});
    truth.push_back ({row.score.true_motion});
  }
  const auto path = evaluation::chainMotions (motions);
  const auto true_path = evaluation::chainMotions (truth);
  const auto relative = evaluation::relativePoseError (path, true_path);
  return {sequence,
          method,
          static_cast<int> (path.size()),
          evaluation::absoluteTrajectoryError (path, true_path),
          relative.translation,
          relative.rotation_deg};
}

} // namespace

std::vector<std::string>
methodsOf (const std::vector<Row>& rows)
{
  return distinct (rows, &Row::method);
}

std::vector<std::string>
sequencesOf (const std::vector<Row>& rows)
{
  return distinct (rows, &Row::sequence);
}

std::map<std::size_t, std::string>
pairNames (const std::vector<Row>& rows)
{
  std::map<std::size_t, std::string> names;
  std::map<std::string, int> count;
  for (const Row& row : rows)
    if (names.emplace (row.pair, row.sequence).second)
      ++count[row.sequence];
  for (const Row& row : rows)
    if (count[row.sequence] > 1)
      names[row.pair] = row.sequence + " " + std::to_string (row.from) + "-" +
                        std::to_string (row.to);
  return names;
}

std::vector<double>
valuesOf (const std::vector<Row>& rows,
          const std::string& method,
          double Score::*value,
          const std::string& sequence)
{
  std::vector<double> values;
  for (const Row& row : rows)
    if (row.method == method && (sequence.empty() || row.sequence == sequence) &&
        std::isfinite (row.score.*value))
      values.push_back (row.score.*value);
  return values;
}

std::vector<Row>
meansPerSequence (const std::vector<Row>& rows)
{
  std::vector<Row> means;
  std::size_t number = 0;
  for (const std::string& sequence : sequencesOf (rows)) {
    for (const std::string& method : methodsOf (rows)) {
      Row row{number, rows[0].dataset, sequence, 0, 0, method, {}};
      for (const Column& c : columns())
        row.score.*c.value =
            evaluation::mean (valuesOf (rows, method, c.value, sequence));
      means.push_back (std::move (row));
    }
    ++number;
  }
  return means;
}

std::vector<PathErrors>
pathErrors (const std::vector<Row>& rows)
{
  std::vector<PathErrors> all;
  for (const std::string& sequence : sequencesOf (rows))
    for (const std::string& method : methodsOf (rows)) {
      const PathErrors path = pathOf (rows, sequence, method);
      if (path.poses > 2)
        all.push_back (path);
    }
  return all;
}

} // namespace pcl_msf::tool
