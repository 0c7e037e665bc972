// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/motion/motion_state.h"
#include "core/motion/rigid_fit.h"

#include <vector>

namespace pcl_msf {

/** \brief A sample of optical flow and how well it is known. */
struct FlowMatch {
  FlowSample sample;
  float whitening[3]; ///< upper triangle xx, xy, yy of a symmetric matrix, 1 / pixels:
                      ///< it turns the deviation into standard deviations
};

/** \brief What optical flow says about the segments' poses. It searched the whole
 * neighbourhood of each place, which steps of a solver from some start do not, but it
 * is less precise and may be wrong: so its cost levels off far away (Geman-McClure),
 * and places without texture tell little. Immutable; thread-safe. */
class FlowEvidence {
public:
  /** \param matches by segment: those of segment k are [begin[k], begin[k + 1])
   * \param camera of the frame that the flow leads to
   * \param cap standard deviations: where the cost has half of its limit */
  FlowEvidence (std::vector<FlowMatch> matches,
                std::vector<int> begin,
                const PinholeCamera& camera,
                double cap);

  /** \brief Mean cost of a segment's matches at a pose, in [0, cap^2 / 2]: half squared
   * standard deviations where they are few. 0 without matches.
   * \param[in,out] information, gradient when given, `weight` times the Gauss-Newton
   * approximation by the pose's parameters is added */
  double
  cost (int segment,
        const UnpackedPose& pose,
        double weight = 0.0,
        Matrix6* information = nullptr,
        Vector6* gradient = nullptr) const;

private:
  std::vector<FlowMatch> matches_;
  std::vector<int> begin_;
  PinholeCamera camera_;
  double cap_;
};

} // namespace pcl_msf
