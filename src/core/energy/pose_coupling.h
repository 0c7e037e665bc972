// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/motion/motion_state.h"
#include <ceres/sized_cost_function.h>
#include <pcl_msf/parameters.h>

namespace pcl_msf {

/** \brief How pose differences become numbers. */
struct CouplingScale {
  double regularizer; ///< sqrt (gamma / number of links)
  double prior;       ///< sqrt (eta / number of links)
  double unit;        ///< per metre: pixels of the level at the link's depth
};

/** \brief Difference d (T_j, T_h) of Eq. 10.
 *
 * Metric: displacement that the two poses give the link's midpoint, and the difference
 * of their rotation vectors times the lever, both in units (pixels). Parameters: the
 * plain difference of the six parameters, as in the paper. */
Vector6
poseDifference (const UnpackedPose& first,
                const UnpackedPose& second,
                const SegmentLink& link,
                double unit,
                PoseDifference form);

struct CoupledPose;

/** \brief d d / d T_j; d d / d T_h is that of the other pose, negative. */
Matrix6
differenceJacobian (const CoupledPose& pose,
                    const SegmentLink& link,
                    double unit,
                    PoseDifference form);

/** \brief A pose as couplings need it, at the state that is evaluated. */
struct CoupledPose {
  UnpackedPose pose;
  Eigen::Matrix3d left_jacobian;

  CoupledPose() = default;
  explicit CoupledPose (const RigidPose& from);
  /** \brief From the six parameters of a block. */
  explicit CoupledPose (const double* parameters);
};

/** \brief Lifted pose regularizer and weight prior of one link (Eq. 10 and 11): six
 * residuals w^2 d and one 1 - w^2, scaled. Parameters: pose j, pose h, w. */
class PoseCouplingCost : public ceres::SizedCostFunction<7, 6, 6, 1> {
public:
  /** \param first, second the poses that parameters mean, kept up to date by who calls
   * Evaluate: a body has many links; null = taken from the parameters each time */
  PoseCouplingCost (const SegmentLink& link,
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
  void
  poseJacobian (const CoupledPose& pose, double sign, double weight, double* out) const;

  SegmentLink link_;
  CouplingScale scale_;
  PoseDifference form_;
  const CoupledPose* first_;
  const CoupledPose* second_;
};

/** \brief The w that minimizes gamma |w^2 d|^2 + eta (1 - w^2)^2. */
double
optimalWeight (double squared_difference, double gamma, double eta);

} // namespace pcl_msf
