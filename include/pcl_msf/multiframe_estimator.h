// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/rgbd_frame.h>

#include <vector>

namespace pcl_msf {

/** \brief Scene flow of a window of frames on images: section 3.1, all pairs jointly.
 *
 * Two frames give exactly what SceneFlowEstimator gives. Time grows with the number of
 * pairs, N (N - 1) / 2, memory with frames plus pairs; windows of 2 to 8 frames are
 * meant, longer ones with MultiframeParameters::max_span.
 *
 * Thread-safe: `estimate` is const and keeps no state.
 */
class PCL_MSF_EXPORT MultiframeEstimator {
public:
  MultiframeEstimator() = default;
  MultiframeEstimator (const EnergyParameters& energy,
                       const SolverParameters& solver,
                       const MultiframeParameters& multiframe = {})
  : energy_ (energy), solver_ (solver), multiframe_ (multiframe)
  {}

  /** \brief Minimizes Eq. 13.
   * \param frames at least two, of one size, in the order of time. All but the one
   * farthest from the reference on each side need normals
   * \param reference index of the frame whose points are followed
   * \param segments of the reference
   * \param guess a motion of the whole scene to try as a start: of the frame after the
   * reference when there is one, else of the one before it
   * \throws InvalidInput for empty frames, sizes that differ, invalid parameters */
  MultiframeSceneFlow
  estimate (const std::vector<RgbdFrame>& frames,
            int reference,
            const Oversegmentation& segments,
            const RigidPose& guess = {}) const;

private:
  EnergyParameters energy_;
  SolverParameters solver_;
  MultiframeParameters multiframe_;
};

} // namespace pcl_msf
