// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf::evaluation {

/** \brief Camera poses from motions between successive frames, the first one at the
 * origin.
 * \param motions element k: k+1_from_k, moves a static point of camera frame k to frame
 * k + 1 \return one pose more than motions, world_from_camera */
PCL_MSF_EXPORT std::vector<RigidPose>
chainMotions (const std::vector<RigidPose>& motions);

/** \brief Absolute trajectory error: root mean square distance of positions after the
 * rigid alignment that makes it smallest (Sturm et al., IROS 2012), metres.
 * \param estimate, truth world_from_camera at the same times; their worlds may differ
 * \return NaN for less than two poses \throws InvalidInput when the numbers differ */
PCL_MSF_EXPORT double
absoluteTrajectoryError (const std::vector<RigidPose>& estimate,
                         const std::vector<RigidPose>& truth);

/** \brief Root mean square drift over a fixed number of frames. */
struct RelativePoseError {
  double translation; ///< metres
  double rotation_deg;
};

/** \brief Relative pose error (Sturm et al., IROS 2012): of the motions from frame i to
 * i + delta, for all i. Arguments as above.
 * \param delta frames, >= 1
 * \return NaN for fewer than delta + 1 poses
 * \throws InvalidInput when the numbers differ or for delta < 1 */
PCL_MSF_EXPORT RelativePoseError
relativePoseError (const std::vector<RigidPose>& estimate,
                   const std::vector<RigidPose>& truth,
                   int delta = 1);

} // namespace pcl_msf::evaluation
