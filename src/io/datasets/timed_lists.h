// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/pose_files.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_msf::io {

struct TimedFile {
  double time; ///< seconds
  std::string file;
};

/** \brief Seconds of a time stamp. Times since 1970 between the years 1973 and 2128 are
 * taken for milliseconds, microseconds or nanoseconds when they have that size; all
 * other numbers are seconds. */
double
secondsOf (double stamp);

/** \brief Reads a list of "timestamp file", sorted by time. \throws IoError */
std::vector<TimedFile>
readTimedFiles (const std::string& path);

/** \brief Reads a trajectory "timestamp tx ty tz qx qy qz qw", sorted by time.
 * \throws IoError, also for a quaternion that is none */
std::vector<TimedPose>
readTrajectory (const std::string& path);

/** \brief Pairs of indices, each index once, the closest pairs first, as the TUM
 * benchmark's associate tool makes them; sorted by time.
 * \param max_difference seconds; pairs must be closer */
std::vector<std::pair<std::size_t, std::size_t>>
associate (const std::vector<TimedFile>& first,
           const std::vector<TimedFile>& second,
           double max_difference);

/** \brief For lists of different units that secondsOf cannot tell, as times since the
 * start: divides the larger times by a thousand, a million or a billion when then half
 * of the shorter list is associated. Lists that are associated already stay as they
 * are. */
void
matchUnits (std::vector<TimedFile>& first,
            std::vector<TimedFile>& second,
            double max_difference);

/** \brief What to say when nothing is associated: the two times that are closest, and
 * the remedy. \param where names of both lists */
std::string
nothingAssociated (const std::vector<TimedFile>& first,
                   const std::vector<TimedFile>& second,
                   double max_difference,
                   const std::pair<std::string, std::string>& where);

/** \brief The pose at a time, interpolated between its neighbours; none unless both
 * are within the difference, seconds. */
std::optional<RigidPose>
poseAt (const std::vector<TimedPose>& poses, double time, double max_difference);

} // namespace pcl_msf::io
