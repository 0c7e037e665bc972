// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/rigid_pose.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief Per label: frame k from frame 0, none for soft bodies. */
using BodyPoses = std::vector<std::optional<RigidPose>>;

/** \brief Reads an object_poses_K.txt: a line per body, `label rigid r11 r12 r13 tx r21
 * r22 r23 ty r31 r32 r33 tz name`, # for comments. \throws IoError */
BodyPoses
readBodyPoses (const std::string& path);

/** \brief `to_from_from` of each body; an empty list stands for frame 0. */
BodyPoses
motionBetween (const BodyPoses& from, const BodyPoses& to);

} // namespace pcl_msf::io
