// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/body_blocks.h"

#include "core/base/parallel_for.h"

namespace pcl_msf {

BodyBlocks::BodyBlocks (const std::vector<int>& body_of,
                        std::size_t bodies,
                        const std::vector<char>& moving)
: segments_of_ (bodies), blocks_ (bodies)
{
  for (std::size_t b = 0; b < bodies; ++b)
    if (moving.empty() || moving[b] != 0)
      moving_.push_back (static_cast<int> (b));
  for (std::size_t k = 0; k < body_of.size(); ++k)
    segments_of_[body_of[k]].push_back (static_cast<int> (k));
}

void
BodyBlocks::addTo (ceres::Problem& problem, std::vector<RigidPose>& poses) const
{
  for (const int b : moving_)
    problem.AddResidualBlock (
        new SegmentBlockCost (blocks_[b]), nullptr, poses[b].parameters.data());
}

void
BodyBlocks::fill (const DataTerm& data,
                  const std::vector<RigidPose>& poses,
                  const StepReach* reach,
                  bool with_jacobians)
{
  parallelFor (data.threads(), static_cast<int> (moving_.size()), 32, [&] (int i) {
    const int b = moving_[i];
    Matrix6 information = Matrix6::Zero();
    Vector6 gradient = Vector6::Zero();
    double cost = 0.0;
    for (const int k : segments_of_[b]) {
      cost += data.of (k).cost();
      if (with_jacobians) {
        information += data.of (k).information;
        gradient += data.of (k).gradient;
      }
    }
    if (with_jacobians && reach)
      reach->damp (b, poses[b], gradient, information);
    if (with_jacobians)
      blocks_[b].set (information, gradient, cost);
    else
      blocks_[b].setCost (cost);
  });
}

} // namespace pcl_msf
