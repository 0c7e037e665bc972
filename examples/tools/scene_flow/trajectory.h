// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/pose_files.h>
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf::tool {

/** \brief What a window that is finished leaves for others. */
struct WindowRecord {
  int window{0};           ///< its number in the recording
  std::vector<int> frames; ///< places in the recording
  int reference{0};        ///< index in `frames`
  bool converged{false};

  /** \brief Of each frame: dominant motion from the reference, identity for itself. */
  std::vector<RigidPose> motions;

  std::vector<double> seconds; ///< of each frame
};

/** \brief Camera poses from the windows' dominant motions; each window goes on where
 * the last one ended. */
class Trajectory {
public:
  void
  add (const WindowRecord& record);

  void
  add (double seconds, const RigidPose& world_from_camera);

  const std::vector<io::TimedPose>&
  poses () const
  {
    return poses_;
  }

private:
  std::vector<io::TimedPose> poses_;
  RigidPose last_; ///< world_from_camera of the last frame so far
};

} // namespace pcl_msf::tool
