// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief Two-frame scene flow on images: the method of section 3 without PCL's types.
 *
 * Thread-safe: `estimate` is const and keeps no state.
 */
class SceneFlowEstimator {
public:
  SceneFlowEstimator() = default;
  SceneFlowEstimator (const EnergyParameters& energy, const SolverParameters& solver)
  : energy_ (energy), solver_ (solver)
  {}

  /** \brief Minimizes Eq. 5.
   * \param reference, current frames of the same size
   * \param segments of the reference
   * \param guess a motion of the whole scene to try as a start,
   * `current_from_reference` \throws InvalidInput for empty frames, sizes that differ,
   * invalid parameters */
  SceneFlow
  estimate (const RgbdFrame& reference,
            const RgbdFrame& current,
            const Oversegmentation& segments,
            const RigidPose& guess = {}) const;

  /** \brief Does estimate take this? \throws InvalidInput when not, as estimate */
  void
  requireUsable (const RgbdFrame& reference,
                 const RgbdFrame& current,
                 const Oversegmentation& segments,
                 const RigidPose& guess = {}) const;

private:
  EnergyParameters energy_;
  SolverParameters solver_;
};

} // namespace pcl_msf
