// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_terms.h"

#include "core/base/parallel_for.h"
#include "core/energy/pose_coupling.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

PointTerms::PointTerms (const PointSamples& samples,
                        const PointSamples& known,
                        const SurfaceSegments& segments,
                        const PointEnergyWeights& weights,
                        int threads,
                        std::vector<RigidPose>& poses)
: samples_ (samples)
, known_ (known)
, segments_ (segments)
, weights_ (weights)
, threads_ (threads)
, poses_ (poses)
, steps_ (segments.size())
, scales_ (segments.links.size(), 1.0)
, shares_ (segments.size())
, blocks_ (segments.size())
{
  for (int i = 0; i < samples.size(); ++i)
    for (const Membership& m : samples.members[i])
      shares_[m.segment].push_back ({i, m.weight});
  for (int i = 0; i < known.size(); ++i)
    for (const Membership& m : known.members[i])
      shares_[m.segment].push_back ({samples.size() + i, m.weight});
  for (int k = 0; k < segments.size(); ++k)
    motions_.emplace_back (poses_[k], segments.centroids[k]);
}

void
PointTerms::addTo (ceres::Problem& problem)
{
  for (int k = 0; k < segments_.size(); ++k)
    problem.AddResidualBlock (
        new SegmentBlockCost (blocks_[k]), nullptr, steps_[k].data());
  for (std::size_t i = 0; i < segments_.links.size(); ++i) {
    const SegmentLink& link = segments_.links[i];
    problem.AddResidualBlock (new SeamCost (motions_, link, weights_.unit, scales_[i]),
                              nullptr,
                              steps_[link.first].data(),
                              steps_[link.second].data());
  }
  for (int k = 0; k < segments_.size(); ++k)
    if (segments_.isFixed (k))
      problem.SetParameterBlockConstant (steps_[k].data());
}

void
PointTerms::fillSegment (int segment, bool with_jacobian)
{
  const double* step = steps_[segment].data();
  const CenteredMotion motion = motions_[segment].after (step);
  const double scale =
      weights_.data / (samples_.size() * weights_.unit * weights_.unit);
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  double cost = 0.0;
  for (const Share& share : shares_[segment]) {
    const PointPull& pull = (*pulls_)[share.sample];
    const Eigen::Vector3d x = motion * pointAt (share.sample).cast<double>();
    const Eigen::Vector3d ax = pull.a * x;
    const double w = scale * share.weight;
    cost += w * (0.5 * x.dot (ax) - pull.b.dot (x) + pull.c);
    if (!with_jacobian)
      continue;
    const Eigen::Vector3d g = ax - pull.b;
    const Eigen::Matrix3d s = skew (x - motion.moved);
    const Eigen::Matrix3d sa = w * s * pull.a; // of a point J = [-s I]
    information.topLeftCorner<3, 3>() += sa * s.transpose();
    information.topRightCorner<3, 3>() += sa;
    information.bottomRightCorner<3, 3>() += w * pull.a;
    gradient.head<3>() += w * (s * g);
    gradient.tail<3>() += w * g;
  }
  if (!with_jacobian) {
    blocks_[segment].setCost (std::max (0.0, cost));
    return;
  }
  information.bottomLeftCorner<3, 3>() =
      information.topRightCorner<3, 3>().transpose().eval();
  Matrix6 change = Matrix6::Identity(); // from turns at the place to the parameters
  change.topLeftCorner<3, 3>() = leftJacobian ({step[0], step[1], step[2]});
  blocks_[segment].set (change.transpose() * information * change,
                        change.transpose() * gradient,
                        std::max (0.0, cost));
}

void
PointTerms::fill (bool with_jacobians)
{
  parallelFor (
      threads_, segments_.size(), 4, [&] (int k) { fillSegment (k, with_jacobians); });
}

void
PointTerms::relaxWeights()
{
  const double links = std::max<double> (1.0, segments_.links.size());
  const double gamma = weights_.regularizer;
  const double eta = gamma * weights_.width * weights_.width;
  for (std::size_t i = 0; i < scales_.size(); ++i) {
    const SegmentLink& link = segments_.links[i];
    scales_[i] = std::sqrt (gamma / links);
    if (!(weights_.width > 0.0))
      continue;
    const double w = optimalWeight (
        seamDifference (
            motions_[link.first], motions_[link.second], link, weights_.unit)
            .squaredNorm(),
        gamma,
        eta);
    scales_[i] *= w * w;
  }
}

void
PointTerms::take (const std::vector<PointPull>& pulls)
{
  pulls_ = &pulls;
  for (std::array<double, 6>& step : steps_)
    step.fill (0.0);
  relaxWeights();
}

void
PointTerms::finish()
{
  for (int k = 0; k < segments_.size(); ++k) {
    motions_[k] = motions_[k].after (steps_[k].data());
    poses_[k] = motions_[k].pose();
  }
}

} // namespace pcl_msf
