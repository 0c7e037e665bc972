// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/pose_coupling.h"

namespace pcl_msf {

/** \brief Lifted pose regularizer and weight prior of one link whose weight no other
 * link shares, with the weight eliminated (variable projection).
 *
 * At each difference d the weight is its optimum, w^2 = eta / (eta + gamma |d|^2), and
 * Eq. 10 and 11 together are the square of the residual sqrt (gamma) w d. Cost and
 * gradient are exactly those; the Gauss-Newton matrix is that of the lifted form with
 * the weight's row and column taken out by the Schur complement: gamma w^4 across d and
 * gamma w^6 along it. Parameters: pose j, pose h. */
class EliminatedCouplingCost : public ceres::SizedCostFunction<6, 6, 6> {
public:
  /** \param first, second see PoseCouplingCost */
  EliminatedCouplingCost (const SegmentLink& link,
                          const CouplingScale& scale,
                          PoseDifference form,
                          const CoupledPose* first = nullptr,
                          const CoupledPose* second = nullptr)
  : link_ (link), scale_ (scale), form_ (form), first_ (first), second_ (second)
  {}

  bool
  Evaluate (double const* const* parameters,
            double* residuals,
            double** jacobians) const override;

private:
  SegmentLink link_;
  CouplingScale scale_;
  PoseDifference form_;
  const CoupledPose* first_;
  const CoupledPose* second_;
};

} // namespace pcl_msf
