// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data_term.h"
#include "core/energy_solve.h"
#include "core/motion_state.h"
#include <pcl_msf/parameters.h>
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief The energy of Eq. 5 on one level: data terms plus coupling of the links. */
class JointEnergy {
public:
  /** \param focal_length of the level, pixels: the unit of pose differences */
  JointEnergy (DataTerm& data,
               const std::vector<SegmentLink>& links,
               const EnergyParameters& parameters,
               double focal_length)
  : data_ (data), links_ (links), parameters_ (parameters), focal_length_ (focal_length)
  {}

  /** \brief Minimizes over poses and weights from the given state (section 3.2);
   * correspondences are renewed after every successful step. */
  SolveOutcome
  minimize (const SolverParameters& solver, SolveMonitor& monitor, MotionState& state);

  /** \brief The energy at a state, by term; linearizes the data term there. */
  EnergyCost
  evaluate (const MotionState& state);

  /** \brief As evaluate, with the data terms of the last sweep. */
  EnergyCost
  presentCost (const MotionState& state) const;

  /** \brief Sets every weight to its optimum for the present poses. */
  void
  relaxWeights (MotionState& state) const;

  /** \brief Regularizer and prior of one link with its weight at its optimum. */
  double
  couplingCost (int link, const UnpackedPose& first, const UnpackedPose& second) const;

  /** \brief w^2 of a link at its optimum: 1 = the poses agree, 0 = nothing in common.
   */
  double
  linkStrength (int link, const UnpackedPose& first, const UnpackedPose& second) const;

  DataTerm&
  data ()
  {
    return data_;
  }

private:
  friend class JointProblem;
  double
  squaredDifference (int link,
                     const UnpackedPose& first,
                     const UnpackedPose& second) const;
  double
  unit (const SegmentLink& link) const;

  DataTerm& data_;
  const std::vector<SegmentLink>& links_;
  const EnergyParameters& parameters_;
  double focal_length_;
};

} // namespace pcl_msf
