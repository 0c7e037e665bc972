// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/concatenation_cost.h"
#include "core/points/seam_cost.h"
#include <ceres/sized_cost_function.h>

namespace pcl_msf {

/** \brief Pose concatenation of one segment (Eq. 14) over steps: its motion into a
 * cloud against that into the cloud before, and on from there.
 *
 * Measured as ConcatenationCost measures it: the squared residuals are the mean over
 * the segment's points of the squared distance between where the two put a point. */
class ChainCost : public ceres::SizedCostFunction<12, 6, 6, 6> {
public:
  /** \param direct, first, second motions before the step, read when evaluated: direct
   * is to be first, then second
   * \param shape of the segment, where direct and first begin
   * \param scale of a displacement */
  ChainCost (const CenteredMotion& direct,
             const CenteredMotion& first,
             const CenteredMotion& second,
             const BodyShape& shape,
             double scale)
  : direct_ (direct), first_ (first), second_ (second), shape_ (shape), scale_ (scale)
  {}

  bool
  Evaluate (double const* const* steps,
            double* residuals,
            double** jacobians) const override;

private:
  const CenteredMotion& direct_;
  const CenteredMotion& first_;
  const CenteredMotion& second_;
  BodyShape shape_;
  double scale_;
};

} // namespace pcl_msf
