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

/** \brief Which segments land where in the current frame, cell by cell.
 *
 * A surface point of the current frame has one origin in the reference. Where segments
 * of different bodies land on one place, that of the larger body is taken for its
 * origin: without this a textureless patch that a moving object comes to hide could
 * move to any other place on the same wall and fit there.
 */
class LandingMap {
public:
  /** \param data its points are entered where the state's poses carry them: those that
   * lie on the current frame's surface and look like it */
  LandingMap (const DataTerm& data,
              const MotionState& state,
              const LandingTuning& tuning,
              int threads);

  /** \brief Share of a segment's points that would land, with a body's pose, where
   * another segment of another and larger body lands. \param sample points of the same
   * segments on the same level */
  double
  occupiedShare (const DataTerm& sample, int segment, int body) const;

private:
  struct Cell {
    std::array<int, 2> segment{-1, -1}; ///< of the two largest bodies
  };
  bool
  larger (int segment, int other) const;
  int
  cellOf (const ImagePlace& at) const;
  void
  enter (int segment, int cell);

  const MotionState& state_;
  std::vector<int> points_; ///< per body
  int cell_;                ///< pixels
  int columns_;
  std::vector<Cell> cells_;
};

} // namespace pcl_msf
