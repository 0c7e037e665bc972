// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/chain_cost.h"
#include "core/points/point_terms.h"
#include <ceres/evaluation_callback.h>
#include <ceres/problem.h>

#include <vector>

namespace pcl_msf {

/** \brief Eq. 5 of two clouds, or Eq. 13 of several, as a Ceres problem: the terms of
 * pairs of clouds, chained by Eq. 14. */
class PointProblem : public ceres::EvaluationCallback {
public:
  PointProblem();

  /** \brief Adds a pair. It must outlive this. */
  void
  add (PointTerms& terms);

  /** \brief Adds Eq. 14 for every segment of three pairs that were added: `direct` is
   * to be `first` and then `second`.
   * \param shapes of the segments, per segment
   * \param weight lambda, divided by the number of segments */
  void
  addChain (PointTerms& direct,
            PointTerms& first,
            PointTerms& second,
            const std::vector<BodyShape>& shapes,
            double weight);

  /** \brief A few Levenberg-Marquardt steps with the pulls as they are, which the terms
   * have taken. \return the energy after it */
  double
  step (int iterations);

  void
  PrepareForEvaluation (bool evaluate_jacobians, bool new_evaluation_point) override;

private:
  std::vector<PointTerms*> terms_;
  int derivatives_{0}; ///< that the present solve may still need
  ceres::Problem problem_;
};

} // namespace pcl_msf
