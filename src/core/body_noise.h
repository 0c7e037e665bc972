// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data_term.h"
#include "core/motion_state.h"
#include "core/segment_pixels.h"

namespace pcl_msf {

/** \brief Measures how well large rigid bodies fit, and weighs their points by it.
 *
 * The noise model allows for what rigid segments leave unexplained on soft surfaces. A
 * body of many segments is truly rigid, so that its residuals show the noise alone:
 * both scales are divided by the median size of their residuals, if that is smaller
 * than the model says. \param data of `pixels`, linearized at the state */
void
sharpenRigidBodies (const DataTerm& data,
                    const MotionState& state,
                    int threads,
                    SegmentPixels& pixels);

} // namespace pcl_msf
