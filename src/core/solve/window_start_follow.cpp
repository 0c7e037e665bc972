// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/window_solve.h"
#include "core/solve/window_start.h"

#include <map>
#include <utility>

/* WindowStart beyond the reference's neighbours: motions that are nearly known. */
namespace pcl_msf {

void
WindowStart::learn (const WindowSolve& solve)
{
  learnt_ = FollowedMotion{{},
                           {},
                           solve.scene().links,
                           solve.scene().noise.areas,
                           solve.brightnessArea(),
                           solve.fit(),
                           {}};
}

/** Per segment, its body: segments that have one pose into each frame that was reached.
 * What moved as one into the last frame alone may have done so for want of evidence. */
std::vector<int>
WindowStart::commonBodies() const
{
  std::map<std::vector<double>, int> bodies;
  std::vector<int> body_of;
  for (int k = 0; k < segments_.size(); ++k) {
    std::vector<double> poses;
    for (const std::vector<RigidPose>& to : to_frame_)
      if (!to.empty())
        poses.insert (poses.end(), to[k].parameters.begin(), to[k].parameters.end());
    const int next = static_cast<int> (bodies.size());
    body_of.push_back (bodies.emplace (std::move (poses), next).first->second);
  }
  return body_of;
}

/** Where the bodies would be at the speed between two frames, or at rest since. */
FollowedMotion
WindowStart::predict (int before, int from) const
{
  FollowedMotion motion = *learnt_;
  motion.body_of = commonBodies();
  motion.guesses.resize (2);
  for (std::size_t k = 0; k < motion.body_of.size(); ++k)
    if (motion.body_of[k] == static_cast<int> (motion.guesses[0].size())) {
      const RigidPose& now = to_frame_[from][k];
      motion.guesses[0].push_back (now * to_frame_[before][k].inverse() * now);
      motion.guesses[1].push_back (now);
    }
  return motion;
}

/** The solution from the reference to the next frame, from what the last one told.
 * \return is there one? */
bool
WindowStart::followStep (int before, int from, int to)
{
  if (!learnt_)
    return false;
  const std::vector<RgbdFrame> pair{frames_[pairs_.reference()], frames_[to]};
  const SolverParameters solver = solverOfRest();
  WindowSolve solve (pair, 0, segments_, energy_, solver, {}, tuning_);
  solve.follow (predict (before, from));
  if (!solve.solveFollowed())
    return false;
  const MotionState found = solve.state().ofPair (0);
  Step& step = steps_[pairs_.between (from, to)];
  step.body = found.body_of;
  for (int k = 0; k < segments_.size(); ++k) {
    to_frame_[to].push_back (found.poseOf (k));
    step.poses.push_back (found.poseOf (k) * to_frame_[from][k].inverse());
  }
  takeNoise (solve.scene().noise);
  learn (solve);
  const BrightnessChange& change = solve.scene().change;
  light_changed_ = light_changed_ || change.local;
  exposure_[to] = {change.gain, change.offset};
  return true;
}

} // namespace pcl_msf
