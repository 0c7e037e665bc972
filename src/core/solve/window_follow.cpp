// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include "core/solve/window_solve.h"
#include "core/window/exposure.h"

#include <algorithm>
#include <numeric>

/* WindowSolve of two frames whose motions are nearly known. */
namespace pcl_msf {

namespace {

/** The bodies of most segments first. */
std::vector<RigidPose>
commonPoses (const WindowState& state, int most)
{
  std::vector<int> segments (state.bodies(), 0);
  for (const int body : state.body_of)
    ++segments[body];
  std::vector<int> order (segments.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (order.begin(), order.end(), [&] (int a, int b) {
    return segments[a] > segments[b];
  });
  order.resize (std::min<std::size_t> (order.size(), most));
  std::vector<RigidPose> poses;
  for (const int body : order)
    poses.push_back (state.poses[0][body]);
  return poses;
}

std::vector<RigidPose>
posesPerSegment (const WindowState& state)
{
  std::vector<RigidPose> poses;
  for (const int body : state.body_of)
    poses.push_back (state.poses[0][body]);
  return poses;
}

} // namespace

/** The exposure, the level of the first round, bodies where they may be now. \return
 * does that explain the frame? */
bool
WindowSolve::startFollowing()
{
  measureNoise();
  scene_.noise.areas = followed_->areas;
  scene_.brightness_area = brightness_area_ = followed_->brightness_area;
  scene_.links = followed_->links;
  scene_.fused_depth = followed_->depth;
  const int at = std::min (scene_.tuning.solve.start_level, levels_ - 1);
  const std::vector<cv::Mat> labels = carryLabels (at);
  const cv::Mat& reference = labels[pairs_.reference()];
  const SegmentPixels points = probePoints (frames_[pairs_.reference()].levels()[at],
                                            reference,
                                            scene_,
                                            pointOptions (scene_, at));
  if (scene_.links.empty())
    pair_start_.linkSegments (reference, at, points);
  state_.body_of = followed_->body_of;
  state_.weights.assign (scene_.links.size(), 1.0);
  state_.poses = {followed_->guesses.front()};
  guessCommonStep();
  compareExposure (at, points);
  enterPrepared (
      at,
      prepareLevel (
          scene_, at, labels, pointOptions (scene_, at), {dense_ && at == 0, false}));
  takeBestGuesses();
  return partLost();
}

/** At the present poses. */
void
WindowSolve::compareExposure (int level, const SegmentPixels& points)
{
  const FrameLevel& current = frames_[1 - pairs_.reference()].levels()[level];
  if (current.intensity.empty())
    return;
  const MatchedIntensities matches =
      matchIntensities (points, state_.ofPair (0), current);
  scene_.change = fitBrightnessChange (matches, scene_.tuning.frame.brightness);
}

/** Per body, the guess at which its points fit best. */
void
WindowSolve::takeBestGuesses()
{
  const DataTerm& probes = level_->probes (0);
  const auto& guesses = followed_->guesses;
  std::vector<std::vector<double>> cost (guesses.size(),
                                         std::vector<double> (state_.bodies(), 0.0));
  for (std::size_t g = 0; g < guesses.size(); ++g)
    for (int k = 0; k < scene_.segments; ++k) {
      const int body = state_.body_of[k];
      const DataTerm::Probe probe = probes.probe (k, guesses[g][body]);
      cost[g][body] +=
          probe.cost + probe.hidden * probe.weight * probes.isolatedHiddenCost();
    }
  for (int b = 0; b < state_.bodies(); ++b)
    for (std::size_t g = 1; g < guesses.size(); ++g)
      if (cost[g][b] < cost[0][b]) {
        cost[0][b] = cost[g][b];
        state_.poses[0][b] = guesses[g][b];
      }
}

/** Per segment, what a residual costs at the present poses, from the sample. */
std::vector<double>
WindowSolve::costsPerResidual() const
{
  const DataTerm& probes = level_->probes (0);
  std::vector<double> costs (scene_.segments, 0.0);
  parallelFor (scene_.threads, scene_.segments, 8, [&] (int k) {
    const DataTerm::Probe probe = probes.probe (k, state_.poses[0][state_.body_of[k]]);
    if (probe.weight > 0.0)
      costs[k] = probe.cost / probe.weight + probe.hidden * probes.isolatedHiddenCost();
  });
  return costs;
}

/** Which segments fit worse than they did in the last frame, and not well. */
std::vector<char>
WindowSolve::lostSince (const std::vector<double>& costs) const
{
  const std::vector<double> now = costsPerResidual();
  std::vector<char> lost (now.size(), 0);
  for (std::size_t k = 0; k < now.size(); ++k)
    lost[k] = now[k] > scene_.tuning.solve.more_cost +
                           std::max (costs[k], scene_.tuning.start.unexplained);
  return lost;
}

/** Segments that do not fit with their bodies leave them, to a neighbour's motion or
 * one of their own. \return are they few? */
bool
WindowSolve::partLost()
{
  const std::vector<char> lost = lostSince (followed_->costs);
  const auto count = std::count (lost.begin(), lost.end(), 1);
  if (static_cast<double> (count) > scene_.tuning.solve.most_lost * scene_.segments)
    return false;
  std::vector<RigidPose> poses = posesPerSegment (state_);
  pair_start_.setCommon (commonPoses (state_, scene_.tuning.bodies.assignment.largest));
  pair_start_.proposeTo (lost, *level_, poses);
  for (int k = 0; k < scene_.segments; ++k)
    if (lost[k] != 0) {
      state_.body_of[k] = state_.bodies();
      state_.poses[0].push_back (poses[k]);
    }
  state_.renumberBodies();
  return true;
}

} // namespace pcl_msf
