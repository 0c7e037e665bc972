// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "inputs.h"
#include "pipeline.h"
#include <pcl_msf/scene_flow_tracker.h>

namespace pcl_msf::tool {

/** \brief Follows a recording frame by frame with a SceneFlowTracker; holds one
 * window's frames at a time. */
class Tracking {
public:
  /** \throws InvalidInput */
  Tracking (const Options& options, Inputs& inputs);

  /** \brief Takes the next frame. \return the result for it alone; without frames for
   * the first one \throws IoError, InvalidInput, UsageError, Interrupted */
  Outcome
  next ();

  /** \brief `world_from_camera` of the frame taken last. */
  RigidPose
  cameraPose () const
  {
    return tracker_.cameraPose();
  }

private:
  struct Taken {
    int index;
    io::RgbdImages images;
  };

  const Options& options_;
  Inputs& inputs_;
  SceneFlowTracker tracker_;
  Taken reference_;
  Taken newest_;
  int frame_{0}; ///< the next one
};

} // namespace pcl_msf::tool
