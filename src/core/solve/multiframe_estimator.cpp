// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/window_solve.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/scene_flow_estimator.h>

namespace pcl_msf {

namespace {

void
requireUsable (const std::vector<RgbdFrame>& frames,
               int reference,
               const MultiframeParameters& parameters)
{
  std::string why;
  if (!parameters.isValid (&why))
    throw InvalidInput ("multiframe parameters: " + why);
  if (frames.size() < 2)
    throw InvalidInput ("a window needs at least two frames");
  if (reference < 0 || reference >= static_cast<int> (frames.size()))
    throw InvalidInput ("the reference is not a frame of the window");
}

} // namespace

MultiframeSceneFlow
MultiframeEstimator::estimate (const std::vector<RgbdFrame>& frames,
                               int reference,
                               const Oversegmentation& segments,
                               const RigidPose& guess) const
{
  requireUsable (frames, reference, multiframe_);
  const SceneFlowEstimator pair (energy_, solver_);
  for (const RgbdFrame& frame : frames)
    pair.requireUsable (frames[reference], frame, segments, guess);
  return WindowSolve (frames,
                      reference,
                      segments,
                      energy_,
                      solver_,
                      multiframe_,
                      currentTuning())
      .run (guess);
}

} // namespace pcl_msf
