// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_solve.h"
#include "core/points/rigid_moments.h"

#include <algorithm>
#include <cmath>

/* Scenes that hardly move: one rigid motion of all. */
namespace pcl_msf {

namespace {

/** Could a camera in the origin have seen all of the points? \param points scaled */
bool
isCameraView (const PointClouds& clouds, const std::vector<Eigen::Vector3f>& points)
{
  return std::all_of (points.begin(), points.end(), [&] (const Eigen::Vector3f& point) {
    return isInCameraView (clouds.asGiven (point));
  });
}

} // namespace

/** One motion of all samples, matched from far to near. */
RigidPose
PointSolve::registerWhole (const RigidPose& start)
{
  const WholeTuning& whole = tuning_.whole;
  takeBrightness (coarse_);
  RigidPose pose = start;
  for (int i = 0; i < whole.steps && !progress_.stopped(); ++i) {
    const double scale =
        whole.from * std::pow (whole.to / whole.from, i / (whole.steps - 1.0));
    const std::vector<RigidPose> all (poses_.size(), pose);
    const std::vector<PointPull> pulls =
        coarse_.pulls (movePoints (samples_, all, threads_), rulesOf (scale), threads_);
    RigidMoments sum;
    for (int s = 0; s < samples_.size(); ++s)
      sum.add (samples_.points[s].cast<double>(), pulls[s], 1.0);
    pose = sum.solve (pose);
  }
  return pose;
}

/** What poses leave uncovered of the source's samples and of the target's. */
std::pair<double, double>
PointSolve::uncovered (const std::vector<RigidPose>& poses)
{
  const double near = std::max (
      tuning_.whole.near, tuning_.whole.spacings * clouds_.target.thin.median_spacing);
  const Coverage coverage = coarse_.covered (
      movePoints (samples_, poses, threads_), tightRules(), near, threads_);
  return {1.0 - coverage.movedShare(), 1.0 - coverage.samplesShare()};
}

/** Of a camera's clouds, whose grid was lost, noise makes layers that fit each other
 * anywhere. What bends and moves explains much of what one rigid motion leaves open;
 * where it does not, motions of parts are chance: they give way to that one. */
void
PointSolve::preferWhole (const RigidPose& start)
{
  const WholeTuning& whole = tuning_.whole;
  if (progress_.stopped() || !isCameraView (clouds_, clouds_.source.thin.points) ||
      !isCameraView (clouds_, clouds_.target.thin.points))
    return;
  const auto [source, target] = uncovered (poses_);
  if (std::max (source, target) < whole.least)
    return;
  const std::vector<RigidPose> all (poses_.size(), registerWhole (start));
  const auto [source_before, target_before] = uncovered (all);
  const bool explains =
      source < whole.left * source_before || target < whole.left * target_before;
  if (explains || progress_.stopped())
    return;
  poses_ = all;
  scattered_ = std::min (source_before, target_before);
}

} // namespace pcl_msf
