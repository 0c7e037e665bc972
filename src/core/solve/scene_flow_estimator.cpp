// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/frame_size.h"
#include "core/solve/window_solve.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <cmath>
#include <string>
#include <utility>

namespace pcl_msf {

namespace {

void
requireSane (const RigidPose& pose, const char* name)
{
  constexpr double kAbsurd = 1e6; // metres or radians; far below what overflows
  for (const double parameter : pose.parameters)
    if (!(std::abs (parameter) <= kAbsurd))
      throw InvalidInput (std::string (name) +
                          " is not finite or absurdly large; give radians and metres");
}

} // namespace

void
SceneFlowEstimator::requireUsable (const RgbdFrame& reference,
                                   const RgbdFrame& current,
                                   const Oversegmentation& segments,
                                   const RigidPose& guess) const
{
  std::string why;
  if (!energy_.isValid (&why))
    throw InvalidInput ("energy parameters: " + why);
  if (!solver_.isValid (&why))
    throw InvalidInput ("solver parameters: " + why);
  if (reference.empty() || current.empty())
    throw InvalidInput ("a frame is empty");
  if (reference.width() != current.width() || reference.height() != current.height())
    throw InvalidInput ("the frames differ in size, " +
                        sizeText ({reference.width(), reference.height()}) + " and " +
                        sizeText ({current.width(), current.height()}) +
                        "; resample one of them");
  if (reference.finestLevel() != current.finestLevel())
    throw InvalidInput ("the frames were made with different finest_level, " +
                        std::to_string (reference.finestLevel()) + " and " +
                        std::to_string (current.finestLevel()) +
                        "; give both the same");
  if (reference.hasIntensity() != current.hasIntensity())
    throw InvalidInput (
        "one frame has colour and the other has none: give it to both or "
        "to neither");
  if (segments.size() < 1 || segments.labels().cols != reference.width() ||
      segments.labels().rows != reference.height())
    throw InvalidInput ("the segmentation is not of the reference frame: it is " +
                        sizeText (segments.labels().size()) + " with " +
                        std::to_string (segments.size()) + " segments, the frame " +
                        sizeText ({reference.width(), reference.height()}));
  requireSane (guess, "the guess");
}

SceneFlow
SceneFlowEstimator::estimate (const RgbdFrame& reference,
                              const RgbdFrame& current,
                              const Oversegmentation& segments,
                              const RigidPose& guess) const
{
  requireUsable (reference, current, segments, guess);
  const std::vector<RgbdFrame> frames{reference, current};
  WindowSolve solve (frames, 0, segments, energy_, solver_, {}, currentTuning());
  return std::move (solve.run (guess).frames[1]);
}

SceneFlow
SceneFlowEstimator::estimateFrom (const RgbdFrame& reference,
                                  const RgbdFrame& current,
                                  const Oversegmentation& segments,
                                  const std::vector<RigidPose>& start) const
{
  requireUsable (reference, current, segments);
  if (start.size() != static_cast<std::size_t> (segments.size()))
    throw InvalidInput ("there are " + std::to_string (start.size()) +
                        " start poses for " + std::to_string (segments.size()) +
                        " segments; give one each");
  for (const RigidPose& pose : start)
    requireSane (pose, "a start pose");
  const std::vector<RgbdFrame> frames{reference, current};
  WindowSolve solve (frames, 0, segments, energy_, solver_, {}, currentTuning());
  solve.startFrom (start);
  return std::move (solve.run ({}).frames[1]);
}

} // namespace pcl_msf
