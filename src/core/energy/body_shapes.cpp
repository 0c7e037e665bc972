// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/body_shapes.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace pcl_msf {

std::vector<BodyShape>
bodyShapes (const SegmentPixels& points, const std::vector<int>& body_of, int bodies)
{
  std::vector<Eigen::Matrix3d> moment (bodies, Eigen::Matrix3d::Zero());
  std::vector<BodyShape> shapes (bodies);
  std::vector<int> count (bodies, 0);
  for (int k = 0; k < points.segments(); ++k) {
    const int b = body_of[k];
    shapes[b].center += points.pixels (k) * points.centroid[k];
    count[b] += points.pixels (k);
  }
  for (int b = 0; b < bodies; ++b)
    shapes[b].center /= std::max (1, count[b]);
  for (int k = 0; k < points.segments(); ++k) {
    const Eigen::Vector3d d = points.centroid[k] - shapes[body_of[k]].center;
    moment[body_of[k]] += points.pixels (k) * (points.spread[k] + d * d.transpose());
  }
  for (int b = 0; b < bodies; ++b) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen (moment[b] /
                                                                std::max (1, count[b]));
    shapes[b].spread = eigen.eigenvectors() *
                       eigen.eigenvalues().cwiseMax (0.0).cwiseSqrt().asDiagonal();
  }
  return shapes;
}

} // namespace pcl_msf
