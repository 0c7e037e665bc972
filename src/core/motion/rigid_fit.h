// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/start_tuning.h"
#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf {

/** \brief A reference point and where optical flow says it went. */
struct FlowSample {
  float x, y, z;       ///< reference point, metres
  float u, v;          ///< target, pixels
  float inverse_depth; ///< of the current frame at the target; 0 = unknown
};

/** \brief Parameters of a robust rigid fit. */
struct RigidFitOptions {
  PinholeCamera camera;       ///< of the current frame
  double inverse_depth_sigma; ///< absolute part, 1 / metres
  double relative_sigma;      ///< share of the inverse depth
  RigidFitTuning tuning;
};

/** \brief Rigid motion of samples by iteratively reweighted Gauss-Newton on the
 * reprojection (pixels) and inverse depth errors, Geman-McClure weights with a scale
 * that follows the median residual. A weak prior keeps the rotation small where the
 * samples do not decide. \param start current_from_reference */
RigidPose
fitRigidMotion (const FlowSample* samples,
                int count,
                const RigidPose& start,
                const RigidFitOptions& options);

/** \brief Mean of the truncated reprojection errors, pixels, limit given. */
double
meanTruncatedError (const FlowSample* samples,
                    int count,
                    const RigidPose& pose,
                    const RigidFitOptions& options,
                    double limit);

/** \brief Each sample's reprojection error at a pose, pixels, with a share of that of
 * its depth. */
std::vector<float>
sampleErrors (const FlowSample* samples,
              int count,
              const RigidPose& pose,
              const RigidFitOptions& options);

} // namespace pcl_msf
