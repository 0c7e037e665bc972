// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/segment_block.h"
#include "core/points/point_matching.h"
#include "core/points/seam_cost.h"
#include <ceres/evaluation_callback.h>
#include <ceres/problem.h>

#include <array>
#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief Weights of the energy on points, every term divided by its number of
 * residuals as in Eq. 5. */
struct PointEnergyWeights {
  double data{1.0};        ///< beta, per squared unit
  double regularizer{1.0}; ///< gamma, per squared unit
  double width{0.0};       ///< of the kernel: difference of poses, in units; 0 = none
  double unit{1.0};        ///< length that counts as 1
};

/** \brief Eq. 5 with points for pixels, as a Ceres problem over steps of the poses: one
 * compressed block per segment, one coupling block per link, whose lifting weight has
 * its best value (Eq. 11) before each step. */
class PointProblem : public ceres::EvaluationCallback {
public:
  /** All must outlive the problem; the poses are the unknowns, but those of fixed
   * segments. \param known further points that are pulled at */
  PointProblem (const PointSamples& samples,
                const PointSamples& known,
                const SurfaceSegments& segments,
                const PointEnergyWeights& weights,
                int threads,
                std::vector<RigidPose>& poses);

  /** \brief A few Levenberg-Marquardt steps with the pulls as they are.
   * \param pulls at the samples, then at the known points \return the energy after it
   */
  double
  step (const std::vector<PointPull>& pulls, int iterations);

  void
  PrepareForEvaluation (bool evaluate_jacobians, bool new_evaluation_point) override;

private:
  struct Share {
    int sample;
    float weight;
  };

  const Eigen::Vector3f&
  pointAt (int place) const
  {
    return place < samples_.size() ? samples_.points[place]
                                   : known_.points[place - samples_.size()];
  }
  void
  relaxWeights ();
  void
  fillSegment (int segment, bool with_jacobian);

  const PointSamples& samples_;
  const PointSamples& known_;
  const SurfaceSegments& segments_;
  PointEnergyWeights weights_;
  int threads_;
  std::vector<RigidPose>& poses_;
  std::vector<CenteredMotion> motions_;      ///< before the step
  std::vector<std::array<double, 6>> steps_; ///< the solver's unknowns
  std::vector<double> scales_;               ///< per link
  int derivatives_{0};                       ///< that the present solve may still need
  std::vector<std::vector<Share>> shares_;   ///< per segment, of the samples
  std::vector<CompressedBlock> blocks_;      ///< per segment
  const std::vector<PointPull>* pulls_{nullptr};
  std::unique_ptr<ceres::Problem> problem_;
};

} // namespace pcl_msf
