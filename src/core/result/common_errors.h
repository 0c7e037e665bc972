// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/data/data_term.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief What all points of a rigid body say about its pose. */
struct BodyInformation {
  Matrix6 data{Matrix6::Zero()}; ///< of the pose parameters, residuals independent
  double excess{1.0};            ///< by which it is too large, >= 1
  int points{0};

  /** \brief What is known when residuals that err alike count once. */
  Matrix6
  worth () const
  {
    return data / excess;
  }
};

/** \brief Bodies' information and by how much it is too large.
 *
 * Errors of depth, of the camera, of interpolation are alike over large parts of a
 * body. The scores b of a body's segments, summed up over tiles, show it: of
 * independent residuals mean b' inv (A) b over the tiles is 6 / tiles; it is
 * 1 + (m - 1) r times as much when residuals within a tile of m are correlated by r
 * (Kish, Survey Sampling 1965: the design effect). What they share over the largest
 * tiles they are taken to share over the whole body of n: the excess is 1 + (n - 1) r.
 * Bodies of few tiles lean on the r of all bodies.
 * \param data linearized at the state's poses
 * \param residual_scale energy times this = sum of 1/2 (residual / sigma)^2 */
std::vector<BodyInformation>
informationOfBodies (const DataTerm& data,
                     const MotionState& state,
                     double residual_scale,
                     const InformationTuning& tuning);

} // namespace pcl_msf
