// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/part_seams.h"

#include <Eigen/Eigenvalues>

namespace pcl_msf {

void
holdSeams (const BodySeams& bodies,
           const std::vector<RigidPose>& poses,
           const PointPartTuning& tuning,
           std::vector<RigidMoments>& moments)
{
  const std::vector<RigidMoments> pulled = moments;
  const auto hold = [&] (int part, int other, const SurfaceSeam& seam) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen (pulled[part].hold());
    if (eigen.eigenvalues()[0] > tuning.free * eigen.eigenvalues().sum())
      return;
    const Eigen::Vector3d free = eigen.eigenvectors().col (0);
    const Eigen::Vector3d along = poses[part].rotation().transpose() * free;
    const Eigen::Vector3d center =
        sectionCenter (bodies.surface, bodies.whole, part, seam, along, tuning.section);
    PointPull pull;
    pull.add (poses[other] * center, free, tuning.seam * seam.edges, 0.0);
    moments[part].add (center, pull, 1.0);
  };
  for (const SurfaceSeam& seam : bodies.seams) {
    hold (seam.first, seam.second, seam);
    hold (seam.second, seam.first, seam);
  }
}

} // namespace pcl_msf
