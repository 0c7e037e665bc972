// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/instruction_set.h"
#include "core/base/tuning/segment_tuning.h"
#include <pcl_msf/rgbd_frame.h>

namespace pcl_msf {

/** \brief Compact clusters of pixels that lie on one plane: CV_32SC1 labels, -1 = no
 * depth. Not necessarily connected.
 *
 * SLIC (Achanta et al., PAMI 2012) with the distance from the cluster's plane, in units
 * of the sensor's noise, as its main feature, and the intensity beside it: planes are
 * affine in inverse depth, so a receding floor is one surface and a depth edge is not.
 * All instruction sets give the same labels. \param size aimed side of a cluster,
 * pixels */
cv::Mat
clusterSurfaces (const FrameLevel& level,
                 double inverse_depth_noise,
                 int size,
                 const SegmentTuning& tuning,
                 int threads,
                 InstructionSet set = chosenInstructionSet());

/** \brief Standard deviation that a pixel of inverse depth w is judged by when asking
 * whether it lies on a plane: the noise, and a share of w for what is not plane. */
inline float
surfaceTolerance (float w, float noise, const SegmentTuning& tuning)
{
  return noise + tuning.plane_share * w;
}

} // namespace pcl_msf
