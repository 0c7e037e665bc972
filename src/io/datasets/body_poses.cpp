// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/body_poses.h"

#include "io/datasets/text_table.h"

#include <algorithm>

namespace pcl_msf::io {

BodyPoses
readBodyPoses (const std::string& path)
{
  const TextTable table (path);
  BodyPoses bodies;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const int label = table.wholeNumber (row, 0, "label");
    if (label != static_cast<int> (row))
      table.fail (row,
                  "label",
                  std::to_string (label) + " where " + std::to_string (row) +
                      " is expected; labels must count from 0 on, one a line");
    const bool rigid = table.wholeNumber (row, 1, "rigid") != 0;
    const RigidPose pose = table.pose (row, 2);
    bodies.push_back (rigid ? std::optional (pose) : std::nullopt);
  }
  return bodies;
}

BodyPoses
motionBetween (const BodyPoses& from, const BodyPoses& to)
{
  BodyPoses motion (std::max (from.size(), to.size()));
  for (std::size_t label = 0; label < motion.size(); ++label) {
    const bool known = (from.empty() || (label < from.size() && from[label])) &&
                       (to.empty() || (label < to.size() && to[label]));
    if (!known)
      continue;
    const RigidPose to_from_first = to.empty() ? RigidPose() : *to[label];
    const RigidPose from_from_first = from.empty() ? RigidPose() : *from[label];
    motion[label] = to_from_first * from_from_first.inverse();
  }
  return motion;
}

} // namespace pcl_msf::io
