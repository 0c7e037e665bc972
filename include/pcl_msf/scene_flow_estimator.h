// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief Two-frame scene flow on images: the method of section 3 without PCL's types.
 *
 * Thread-safe: `estimate` is const and keeps no state.
 */
class PCL_MSF_EXPORT SceneFlowEstimator {
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

  /** \brief Minimizes Eq. 5 from given poses; optical flow serves only to fit the
   * exposure.
   * \param start a pose per segment, `current_from_reference`
   * \throws InvalidInput as above, and for another number of poses than of segments */
  SceneFlow
  estimateFrom (const RgbdFrame& reference,
                const RgbdFrame& current,
                const Oversegmentation& segments,
                const std::vector<RigidPose>& start) const;

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
