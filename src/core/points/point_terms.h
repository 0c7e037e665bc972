// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/segment_block.h"
#include "core/points/point_matching.h"
#include "core/points/seam_cost.h"
#include <ceres/problem.h>

#include <array>
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

/** \brief Eq. 5 of two clouds with points for pixels, over steps of the poses: one
 * compressed block per segment, one coupling block per link, whose lifting weight has
 * its best value (Eq. 11) before each step. A PointProblem holds one or several. */
class PointTerms {
public:
  /** All must outlive this; the poses are the unknowns, but those of fixed segments.
   * \param known further points that are pulled at */
  PointTerms (const PointSamples& samples,
              const PointSamples& known,
              const SurfaceSegments& segments,
              const PointEnergyWeights& weights,
              int threads,
              std::vector<RigidPose>& poses);
  PointTerms (const PointTerms&) = delete; // the problem holds addresses
  PointTerms&
  operator= (const PointTerms&) = delete;

  void
  addTo (ceres::Problem& problem);

  /** \brief Before a step of the problem.
   * \param pulls at the samples, then at the known points; must outlive the step */
  void
  take (const std::vector<PointPull>& pulls);

  /** \brief At the present step. */
  void
  fill (bool with_jacobians);

  /** \brief The step is made. */
  void
  finish ();

  int
  size () const
  {
    return segments_.size();
  }
  double
  unit () const
  {
    return weights_.unit;
  }
  /** \brief Of all segments before the step. */
  const std::vector<CenteredMotion>&
  motions () const
  {
    return motions_;
  }
  double*
  step (int segment)
  {
    return steps_[segment].data();
  }

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
  std::vector<CenteredMotion> motions_;
  std::vector<std::array<double, 6>> steps_; ///< the solver's unknowns
  std::vector<double> scales_;               ///< per link
  std::vector<std::vector<Share>> shares_;   ///< per segment, of the samples
  std::vector<CompressedBlock> blocks_;      ///< per segment
  const std::vector<PointPull>* pulls_{nullptr};
};

} // namespace pcl_msf
