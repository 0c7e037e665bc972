// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/multi_frame_solve.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <algorithm>

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

/** Two frames: Eq. 5, by the two-frame estimator. */
MultiframeSceneFlow
estimatePair (const SceneFlowEstimator& estimator,
              const std::vector<RgbdFrame>& frames,
              int reference,
              const Oversegmentation& segments,
              const RigidPose& guess)
{
  const int other = 1 - reference;
  MultiframeSceneFlow result;
  result.reference = reference;
  result.frames.resize (2);
  result.frames[other] =
      estimator.estimate (frames[reference], frames[other], segments, guess);
  result.frames[reference].report = result.frames[other].report;
  PairMotion motion{reference, other, {}};
  for (const SegmentMotion& segment : result.frames[other].segments)
    motion.segments.push_back (segment.current_from_reference);
  result.motions.push_back (std::move (motion));
  return result;
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
  if (frames.size() == 2 && !multiframe_.static_background)
    return estimatePair (pair, frames, reference, segments, guess);
  return MultiFrameSolve (frames, reference, segments, energy_, solver_, multiframe_)
      .run (guess);
}

} // namespace pcl_msf
