// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/timed_lists.h"

#include <Eigen/Geometry>

#include "core/base/flatten.h"
#include "core/base/number_text.h"
#include "io/datasets/text_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace pcl_msf::io {

namespace {

template <typename Timed>
void
sortByTime (std::vector<Timed>& list, double Timed::*time)
{
  std::stable_sort (list.begin(), list.end(), [time] (const Timed& a, const Timed& b) {
    return a.*time < b.*time;
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
    table.fail (row,
                "quaternion",
                "its length is " + generalText (q.norm()) +
                    ", not 1; write a unit quaternion as qx qy qz qw");
  return q.normalized();
}

/** The rigid motion a part of the way from one pose to another. Flat as numericalRank
 * in segment_results.cpp: no copy of a function for aligned quaternions is left. */
PCL_MSF_FLATTEN RigidPose
between (const RigidPose& from, const RigidPose& to, double part)
{
  const Eigen::Quaterniond q0 (from.rotation()), q1 (to.rotation());
  const Eigen::Vector3d t = (1.0 - part) * from.translation() + part * to.translation();
  return RigidPose::fromMatrix (q0.slerp (part, q1).toRotationMatrix(), t);
}

} // namespace

double
secondsOf (double stamp)
{
  constexpr double kEarliest = 1e8, kLatest = 5e9; // seconds since 1970
  for (const double unit : {1e3, 1e6, 1e9})
    if (stamp >= kEarliest * unit && stamp <= kLatest * unit)
      return stamp / unit;
  return stamp;
}

std::vector<TimedFile>
readTimedFiles (const std::string& path)
{
  const TextTable table (path);
  std::vector<TimedFile> list;
  for (std::size_t row = 0; row < table.rows(); ++row)
    list.push_back ({secondsOf (table.number (row, 0, "timestamp")),
                     table.word (row, 1, "filename")});
  sortByTime (list, &TimedFile::time);
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
        {secondsOf (table.number (row, 0, "timestamp")),
         RigidPose::fromMatrix (quaternionOf (table, row).toRotationMatrix(), t)});
  }
  sortByTime (list, &TimedPose::seconds);
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

void
matchUnits (std::vector<TimedFile>& first,
            std::vector<TimedFile>& second,
            double max_difference)
{
  if (first.empty() || second.empty() ||
      !associate (first, second, max_difference).empty())
    return;
  auto& larger = first.back().time > second.back().time ? first : second;
  const std::vector<TimedFile> given = larger;
  for (const double unit : {1e3, 1e6, 1e9}) {
    for (std::size_t i = 0; i < given.size(); ++i)
      larger[i].time = given[i].time / unit;
    if (2 * associate (first, second, max_difference).size() >=
        std::min (first.size(), second.size()))
      return;
  }
  larger = given;
}

std::string
nothingAssociated (const std::vector<TimedFile>& first,
                   const std::vector<TimedFile>& second,
                   double max_difference,
                   const std::pair<std::string, std::string>& where)
{
  if (first.empty() || second.empty())
    return "no image in " + (first.empty() ? where.first : where.second) +
           "; give a list with a line \"timestamp filename\" for each";
  double best = std::numeric_limits<double>::infinity();
  std::string times;
  for (const TimedFile& a : first) {
    const auto later = std::lower_bound (
        second.begin(), second.end(), a.time, [] (const TimedFile& b, double at) {
          return b.time < at;
        });
    for (const auto b : {later == second.begin() ? later : later - 1, later})
      if (b != second.end() && std::abs (b->time - a.time) < best) {
        best = std::abs (b->time - a.time);
        times = fixedText (a.time, 6) + " in " + where.first + " and " +
                fixedText (b->time, 6) + " in " + where.second;
      }
  }
  return "the closest are " + times + ", " + generalText (best) +
         " s apart, and less than " + generalText (max_difference) +
         " s are paired; give both lists the same clock in seconds, or allow a larger "
         "max_time_difference (--max-time-difference)";
}

std::optional<RigidPose>
poseAt (const std::vector<TimedPose>& poses, double time, double max_difference)
{
  const auto later = std::lower_bound (
      poses.begin(), poses.end(), time, [] (const TimedPose& pose, double at) {
        return pose.seconds < at;
      });
  if (later == poses.end() || later->seconds - time > max_difference)
    return std::nullopt;
  if (later->seconds == time)
    return later->world_from_camera;
  if (later == poses.begin() || time - (later - 1)->seconds > max_difference)
    return std::nullopt;
  const TimedPose& before = *(later - 1);
  const double part = (time - before.seconds) / (later->seconds - before.seconds);
  return between (before.world_from_camera, later->world_from_camera, part);
}

} // namespace pcl_msf::io
