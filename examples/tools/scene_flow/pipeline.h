// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "inputs.h"
#include "options.h"
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/multiframe_scene_flow.h>

#include <vector>

namespace pcl_msf::tool {

/** \brief What the output of one window is made of. */
struct Outcome {
  std::vector<int> indices; ///< per frame of the window, its place in the recording
  MultiframeSceneFlow result;
  std::vector<io::RgbdImages>
      images; ///< as loaded, per frame of the window; empty where not needed
  io::RunSeconds seconds;
  int first_new{0}; ///< results of the frames before this one are written already

  /** \brief Index in the recording of the frame whose points are followed. */
  int
  reference () const
  {
    return indices[result.reference];
  }
  /** \brief The last frame of the window that is a target, and its result. */
  int
  lastTarget () const;
  const SceneFlow&
  lastFlow () const
  {
    return result.frames[lastTarget()];
  }
};

/** \brief From files to the result of the window that begins at a frame.
 * \throws IoError, InvalidInput, UsageError, Interrupted */
Outcome
runPipeline (const Options& options, Inputs& inputs, int first, int count);

} // namespace pcl_msf::tool
