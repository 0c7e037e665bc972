// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/methods/method.h"

namespace pcl_msf::tool {

/** \brief Gives an optical flow its third dimension: each point goes to where the
 * current frame has depth at its target; where it has none, z stays as it was.
 * Sets `displacement` from `flow`, and `lifted`. */
void
liftByDepth (const PairData& pair, Estimate& estimate);

/** \brief Moves all points by one motion. Sets flow, displacement and dominant. */
void
moveRigidly (const PairData& pair, const RigidPose& pose, Estimate& estimate);

} // namespace pcl_msf::tool
