// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/concatenation_cost.h"
#include "core/segments/segment_pixels.h"

#include <vector>

namespace pcl_msf {

/** \brief Centre and spread of each body's points, in the points' frame. */
std::vector<BodyShape>
bodyShapes (const SegmentPixels& points, const std::vector<int>& body_of, int bodies);

} // namespace pcl_msf
