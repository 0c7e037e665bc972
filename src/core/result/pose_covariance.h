// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/data/data_term.h"
#include "core/motion/motion_state.h"
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief Covariances of the segments' pose parameters (see SceneFlow), and the
 * information of segments and groups, which is their inverse.
 * \param data of level 0, linearized at the result's poses
 * \param residual_scale energy times this = sum of 1/2 (residual / sigma)^2
 * \param result with segments, their visible points, groups' numbers and links
 * \return per segment; NaN for undetermined ones */
std::vector<Matrix6>
fillInformation (const DataTerm& data,
                 const std::vector<SegmentLink>& links,
                 const MotionState& state,
                 double residual_scale,
                 const InformationTuning& tuning,
                 int threads,
                 SceneFlow& result);

/** \brief d (moved point) / d (pose parameters). \param left_jacobian of the pose's
 * rotation vector \param turned the point, rotated by the pose */
Eigen::Matrix<double, 3, 6>
pointJacobian (const Eigen::Matrix3d& left_jacobian, const Eigen::Vector3d& turned);

} // namespace pcl_msf
