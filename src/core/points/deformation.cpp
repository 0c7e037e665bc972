// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/deformation.h"

#include "core/base/parallel_for.h"
#include "core/motion/motion_state.h"

namespace pcl_msf {

MovedPoints
movePoints (const PointSamples& samples,
            const std::vector<RigidPose>& poses,
            int threads)
{
  const std::vector<UnpackedPose> unpacked (poses.begin(), poses.end());
  MovedPoints moved;
  moved.points.resize (samples.size());
  moved.normals.resize (samples.size());
  moved.brightness = samples.brightness;
  parallelFor (threads, samples.size(), 512, [&] (int i) {
    const Eigen::Vector3d p = samples.points[i].cast<double>();
    const Eigen::Vector3d n = samples.normals[i].cast<double>();
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    Eigen::Vector3d m = Eigen::Vector3d::Zero();
    for (const Membership& member : samples.members[i]) {
      const UnpackedPose& pose = unpacked[member.segment];
      x += member.weight * (pose.rotation * p + pose.translation);
      m += member.weight * (pose.rotation * n);
    }
    moved.points[i] = x.cast<float>();
    moved.normals[i] = m.normalized().cast<float>();
  });
  return moved;
}

} // namespace pcl_msf
