// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_props.h>
#include <synthetic/skeleton.h>

namespace pcl_msf::synthetic {

int
Skeleton::add (const Joint& joint)
{
  joints_.push_back (joint);
  return static_cast<int> (joints_.size()) - 1;
}

Isometry
Skeleton::worldFromLink (int link, double phase) const
{
  Isometry pose = Isometry::Identity();
  for (int i = link; i >= 0; i = joints_[i].parent) {
    const Joint& joint = joints_[i];
    const Eigen::Vector3d vector = swingAt (phase, joint.start) * joint.turn;
    const double angle = vector.norm();
    Isometry parent_from_link = joint.parent_from_joint;
    if (angle > 0.0)
      parent_from_link.rotate (Eigen::AngleAxisd (angle, vector / angle));
    pose = parent_from_link * pose;
  }
  return pose;
}

Motion
linkMotion (const std::shared_ptr<const Skeleton>& skeleton, int link)
{
  return [=] (double phase) { return skeleton->worldFromLink (link, phase); };
}

} // namespace pcl_msf::synthetic
