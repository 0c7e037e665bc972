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
  /** \param data whose points are entered */
  LandingMap (const DataTerm& data, const LandingTuning& tuning);

  /** \brief Enters the points where a state's poses carry them: those that lie on the
   * current frame's surface and look like it.
   *
   * What earlier states entered is forgotten; of segments that stay with their body it
   * is known already: the bodies' poses must be the same in all. \param state stays in
   * use \param costs per segment: mean cost per residual with its body */
  void
  enter (const MotionState& state, std::vector<double> costs, int threads);

  /** \brief Share of a segment's points that would land, with a body's pose, where
   * another segment of another and larger body lands, unless that one fits there
   * clearly worse. \param sample points of the same segments on the same level
   * \param cost mean one per residual of the segment with that body */
  double
  occupiedShare (const DataTerm& sample, int segment, int body, double cost) const;

private:
  struct Cell {
    std::array<int, 2> segment{-1, -1}; ///< of the two largest bodies
  };
  bool
  larger (int segment, int other) const;
  int
  cellOf (const ImagePlace& at) const;
  void
  enterCell (int segment, int cell);
  std::vector<int>
  landingsOf (int segment, const RigidPose& pose) const;

  /** Cells that a segment lands on with a body. */
  struct Landed {
    int body{-1};
    std::vector<int> cells;
  };

  const DataTerm& data_;
  const LandingTuning tuning_;
  int columns_;
  const MotionState* state_{nullptr};
  std::vector<double> costs_;  ///< per segment
  std::vector<int> points_;    ///< per body
  std::vector<Landed> landed_; ///< per segment
  std::vector<Cell> cells_;
};

} // namespace pcl_msf
