// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/timed_lists.h"

#include <Eigen/Geometry>

#include "io/datasets/text_table.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_msf::io {

namespace {

template <typename Timed>
void
sortByTime (std::vector<Timed>& list)
{
  std::stable_sort (list.begin(), list.end(), [] (const Timed& a, const Timed& b) {
    return a.time < b.time;
  });
}

Eigen::Quaterniond
quaternionOf (const TextTable& table, std::size_t row)
{
  const Eigen::Quaterniond q (table.number (row, 7, "qw"),
                              table.number (row, 4, "qx"),
                              table.number (row, 5, "qy"),
                              table.number (row, 6, "qz"));
  if (!(std::abs (q.norm() - 1.0) < 0.01))
    table.fail (row, "quaternion", "its length is not 1; it is no rotation");
  return q.normalized();
}

/** The rigid motion a part of the way from one pose to another. Flat as numericalRank
 * in dense_result.cpp: no copy of a function for aligned quaternions is left. */
[[gnu::flatten]] RigidPose
between (const RigidPose& from, const RigidPose& to, double part)
{
  const Eigen::Quaterniond q0 (from.rotation()), q1 (to.rotation());
  const Eigen::Vector3d t = (1.0 - part) * from.translation() + part * to.translation();
  return RigidPose::fromMatrix (q0.slerp (part, q1).toRotationMatrix(), t);
}

} // namespace

std::vector<TimedFile>
readTimedFiles (const std::string& path)
{
  const TextTable table (path);
  std::vector<TimedFile> list;
  for (std::size_t row = 0; row < table.rows(); ++row)
    list.push_back (
        {table.number (row, 0, "timestamp"), table.word (row, 1, "filename")});
  sortByTime (list);
  return list;
}

std::vector<TimedPose>
readTrajectory (const std::string& path)
{
  const TextTable table (path);
  std::vector<TimedPose> list;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Eigen::Vector3d t (table.number (row, 1, "tx"),
                             table.number (row, 2, "ty"),
                             table.number (row, 3, "tz"));
    list.push_back (
        {table.number (row, 0, "timestamp"),
         RigidPose::fromMatrix (quaternionOf (table, row).toRotationMatrix(), t)});
  }
  sortByTime (list);
  return list;
}

std::vector<std::pair<std::size_t, std::size_t>>
associate (const std::vector<TimedFile>& first,
           const std::vector<TimedFile>& second,
           double max_difference)
{
  std::vector<std::tuple<double, std::size_t, std::size_t>> candidates;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    while (begin < second.size() &&
           second[begin].time <= first[i].time - max_difference)
      ++begin;
    for (std::size_t j = begin; j < second.size(); ++j) {
      const double difference = std::abs (second[j].time - first[i].time);
      if (difference < max_difference)
        candidates.emplace_back (difference, i, j);
      else if (second[j].time > first[i].time)
        break;
    }
  }
  std::sort (candidates.begin(), candidates.end());
  std::vector<bool> first_taken (first.size()), second_taken (second.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [difference, i, j] : candidates)
    if (!first_taken[i] && !second_taken[j]) {
      first_taken[i] = second_taken[j] = true;
      pairs.emplace_back (i, j);
    }
  std::sort (pairs.begin(), pairs.end());
  return pairs;
}

std::optional<RigidPose>
poseAt (const std::vector<TimedPose>& poses, double time, double max_difference)
{
  const auto later = std::lower_bound (
      poses.begin(), poses.end(), time, [] (const TimedPose& pose, double at) {
        return pose.time < at;
      });
  if (later == poses.end() || later->time - time > max_difference)
    return std::nullopt;
  if (later->time == time)
    return later->pose;
  if (later == poses.begin() || time - (later - 1)->time > max_difference)
    return std::nullopt;
  const TimedPose& before = *(later - 1);
  return between (
      before.pose, later->pose, (time - before.time) / (later->time - before.time));
}

} // namespace pcl_msf::io
