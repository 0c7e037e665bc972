// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/points/point_matching.h"
#include "core/surface/surface_segments.h"

#include <vector>

namespace pcl_msf {

/** \brief How parts are matched with the target. */
MatchRules
fineRules (double distance, const PointPartTuning& tuning);

/** \brief How one target tells parts apart. */
struct BorderView {
  MatchTarget& target;
  const std::vector<RigidPose>& poses;  ///< per segment
  const std::vector<float>& brightness; ///< per point; may be empty
  MatchRules rules;
  double spacing; ///< of the target
};

/** \brief Where one part ends and the next one begins. */
struct PartBorders {
  const Surface& surface;
  const SurfaceSegments& segments;
  const std::vector<int>& part_of; ///< per segment
  const std::vector<char>& rigid;  ///< per part

  /** \brief The part of every point: between parts that of the motion that fits the
   * targets best, all together. */
  std::vector<int>
  draw (const std::vector<BorderView>& views,
        const PointPartTuning& tuning,
        int threads) const;

  /** \brief A point that follows a part as a whole. */
  std::vector<Membership>
  oneOf (int part) const;
};

} // namespace pcl_msf
