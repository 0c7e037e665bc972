// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/part_seams.h"

#include <Eigen/Eigenvalues>

namespace pcl_msf {

void
holdSeams (const std::vector<SurfaceSeam>& seams,
           const std::vector<RigidPose>& poses,
           const std::vector<char>& rigid,
           const PointPartTuning& tuning,
           std::vector<RigidMoments>& moments)
{
  const std::vector<RigidMoments> pulled = moments;
  const auto hold = [&] (int part, int other, const SurfaceSeam& seam) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen (pulled[part].hold());
    if (eigen.eigenvalues()[0] > tuning.free * eigen.eigenvalues().sum())
      return;
    PointPull pull;
    pull.add (poses[other] * seam.center,
              eigen.eigenvectors().col (0),
              tuning.seam * seam.edges,
              0.0);
    moments[part].add (seam.center, pull, 1.0);
  };
  for (const SurfaceSeam& seam : seams)
    if (rigid[seam.first] && rigid[seam.second]) {
      hold (seam.first, seam.second, seam);
      hold (seam.second, seam.first, seam);
    }
}

} // namespace pcl_msf
