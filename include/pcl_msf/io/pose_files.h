// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/rigid_pose.h>

#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief Writes the poses of a window, as YAML or, when the path ends in ".json", as
 * JSON: `reference`, `frames` (their indices), `dominant` (the dominant motion from the
 * reference to each other frame), `pairs` with `from`, `to` and `segments`, a list of
 * six-element poses (angle-axis, radians; translation, metres; `to_from_from`).
 * \param frames places of the window's frames in their recording; 0, 1, ... if empty
 * \throws IoError */
PCL_MSF_EXPORT void
writePoses (const std::string& path,
            const MultiframeSceneFlow& result,
            const std::vector<int>& frames = {});

/** \brief A camera pose with its time. */
struct TimedPose {
  double seconds{0.0};
  RigidPose world_from_camera;
};

/** \brief Writes a trajectory as the TUM RGB-D benchmark does: a line `timestamp tx ty
 * tz qx qy qz qw` per pose, seconds and metres. \throws IoError */
PCL_MSF_EXPORT void
writeTrajectory (const std::string& path, const std::vector<TimedPose>& poses);

} // namespace pcl_msf::io
