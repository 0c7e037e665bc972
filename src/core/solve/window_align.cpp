// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/window_solve.h"

#include <algorithm>

/* Where all bodies of WindowSolve have gone together, beyond what was predicted. */
namespace pcl_msf {

/** A level on which all segments are one body. */
void
WindowSolve::enterWhole (int level)
{
  const std::vector<cv::Mat> labels = carryLabels (level);
  const PointOptions options = pointOptions (scene_, level);
  compareExposure (level,
                   probePoints (frames_[pairs_.reference()].levels()[level],
                                labels[pairs_.reference()],
                                scene_,
                                options));
  level_ = std::make_unique<WindowLevel> (
      scene_,
      level,
      prepareLevel (scene_, level, labels, pointOptions (scene_, level)),
      energy_);
}

/** Registers the frame as one body, coarse to fine. \return its motion */
RigidPose
WindowSolve::registerWhole (const RigidPose& guess)
{
  state_.body_of.assign (scene_.segments, 0);
  state_.poses = {{guess}};
  const int finest = std::min (scene_.tuning.solve.start_level + 1, levels_ - 1);
  for (int level = coarsestWhole(); level >= finest; --level) {
    enterWhole (level);
    monitor_.enter ("align", level, 0.0, 0.0, user_.max_iterations);
    minimize (user_.max_iterations);
  }
  return state_.poses[0][0];
}

/** A hand that holds a camera does not go on at its last speed. What registering the
 * frame as a whole, from the best guess, adds to the largest body's motion is a guess
 * for all. */
void
WindowSolve::guessCommonStep()
{
  const WindowState predicted = state_;
  const int largest = predicted.largestBody();
  enterWhole (coarsestWhole());
  takeBestGuesses();
  const RigidPose before = state_.poses[0][largest];
  const RigidPose step = registerWhole (before) * before.inverse();
  state_ = predicted;
  std::vector<RigidPose> guesses;
  for (const RigidPose& pose : state_.poses[0])
    guesses.push_back (step * pose);
  followed_->guesses.push_back (std::move (guesses));
}

int
WindowSolve::coarsestWhole() const
{
  return std::min (scene_.tuning.solve.align_level, levels_ - 1);
}

} // namespace pcl_msf
