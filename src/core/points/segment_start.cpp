// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/segment_start.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace pcl_msf {

namespace {

RigidPose
fitOnce (const Eigen::Matrix3Xd& from,
         const Eigen::Matrix3Xd& to,
         const Eigen::VectorXd& weights)
{
  const double sum = weights.sum();
  const Eigen::Vector3d a = from * weights / sum;
  const Eigen::Vector3d b = to * weights / sum;
  const Eigen::Matrix3d h =
      (to.colwise() - b) * weights.asDiagonal() * (from.colwise() - a).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd (
      h, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0)
    signs[2] = -1.0;
  const Eigen::Matrix3d r =
      svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  return RigidPose::fromMatrix (r, b - r * a);
}

} // namespace

RigidPose
fitPairs (const Eigen::Matrix3Xd& from,
          const Eigen::Matrix3Xd& to,
          const std::vector<double>& weights,
          double scale,
          const LimbTuning& tuning)
{
  const Eigen::Map<const Eigen::VectorXd> given (
      weights.data(), static_cast<Eigen::Index> (weights.size()));
  Eigen::VectorXd w = given;
  RigidPose pose;
  for (int round = 0; round < tuning.fit_rounds; ++round) {
    pose = fitOnce (from, to, w);
    const Eigen::Matrix3d r = pose.rotation();
    for (Eigen::Index i = 0; i < w.size(); ++i) {
      const Eigen::Vector3d d = r * from.col (i) + pose.translation() - to.col (i);
      const double g = scale * scale / (scale * scale + d.squaredNorm());
      w[i] = given[i] * g * g;
    }
  }
  return pose;
}

void
startSegments (const PointSamples& samples,
               const std::vector<Eigen::Vector3f>& target,
               const std::vector<PointPair>& pairs,
               double scale,
               const LimbTuning& tuning,
               std::vector<RigidPose>& poses)
{
  std::vector<std::vector<const PointPair*>> of (poses.size());
  for (const PointPair& pair : pairs)
    for (const Membership& m : samples.members[pair.source])
      of[m.segment].push_back (&pair);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (static_cast<int> (of[k].size()) < tuning.fit_pairs)
      continue;
    const auto n = static_cast<Eigen::Index> (of[k].size());
    Eigen::Matrix3Xd from (3, n);
    Eigen::Matrix3Xd to (3, n);
    std::vector<double> weights;
    for (Eigen::Index i = 0; i < n; ++i) {
      from.col (i) = samples.points[of[k][i]->source].cast<double>();
      to.col (i) = target[of[k][i]->target].cast<double>();
      weights.push_back (of[k][i]->weight + 1e-6);
    }
    poses[k] = fitPairs (from, to, weights, scale, tuning);
  }
}

} // namespace pcl_msf
