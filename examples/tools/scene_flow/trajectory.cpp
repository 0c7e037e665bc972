// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "trajectory.h"

namespace pcl_msf::tool {

void
Trajectory::add (const WindowRecord& record)
{
  // The window's frame 0 is the last one's last.
  const RigidPose world_from_reference = last_ * record.motions.front();
  for (std::size_t k = poses_.empty() ? 0 : 1; k < record.motions.size(); ++k)
    poses_.push_back (
        {record.seconds[k], world_from_reference * record.motions[k].inverse()});
  last_ = poses_.back().world_from_camera;
}

void
Trajectory::add (double seconds, const RigidPose& world_from_camera)
{
  poses_.push_back ({seconds, world_from_camera});
}

} // namespace pcl_msf::tool
