// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/body_tuning.h"
#include "core/data/data_term.h"
#include "core/data/surface_sample.h"
#include "core/motion/motion_state.h"

#include <array>
#include <vector>

namespace pcl_msf {

/** \brief Which segments say that they are seen where in the current frame.
 *
 * A surface point of the current frame has one origin in the reference. Where two
 * segments of different bodies claim the same place, the one of the larger body is
 * believed: a textureless patch behind a moving object, say, can hide from its own
 * occlusion by moving to any other place on the same wall, but all of those are taken.
 */
class ClaimMap {
public:
  /** \param data its points make the claims, at the state's poses: those that lie on
   * the current frame's surface and look like it */
  ClaimMap (const DataTerm& data,
            const MotionState& state,
            const ClaimTuning& tuning,
            int threads);

  /** \brief Share of a segment's points that would land, with a body's pose, where
   * another segment of another and larger body claims to be. \param sample points of
   * the same segments on the same level */
  double
  takenShare (const DataTerm& sample, int segment, int body) const;

private:
  struct Cell {
    std::array<int, 2> segment{-1, -1}; ///< of the two largest bodies
  };
  bool
  larger (int segment, int other) const;
  int
  cellOf (const ImagePlace& at) const;
  void
  claim (int segment, int cell);

  const MotionState& state_;
  std::vector<int> points_; ///< per body
  int cell_;                ///< pixels
  int columns_;
  std::vector<Cell> cells_;
};

} // namespace pcl_msf
