// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/window_start.h"

#include "core/energy/concatenation_cost.h"
#include "core/segments/segment_graph.h"
#include "core/solve/window_solve.h"
#include "core/window/segment_carrier.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace pcl_msf {

namespace {

constexpr int kFinestLevel = 1; // of two adjacent frames; the window solves the finest

/** The labels that points with depth bear, ascending. */
std::vector<int>
labelsInUse (const cv::Mat& labels, const cv::Mat& inverse_depth, int segments)
{
  std::vector<char> used (segments, 0);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (labels.at<int> (y, x) >= 0 && inverse_depth.at<float> (y, x) > 0.0f)
        used[labels.at<int> (y, x)] = 1;
  std::vector<int> result;
  for (int k = 0; k < segments; ++k)
    if (used[k])
      result.push_back (k);
  return result;
}

} // namespace

WindowStart::WindowStart (const std::vector<RgbdFrame>& frames,
                          const FramePairs& pairs,
                          const Oversegmentation& segments,
                          const EnergyParameters& energy,
                          const SolverParameters& solver,
                          const Tuning& tuning)
: frames_ (frames)
, pairs_ (pairs)
, segments_ (segments)
, energy_ (energy)
, solver_ (solver)
, tuning_ (tuning)
, clock_ (solver_)
, labels_ (frames.size())
, steps_ (pairs.count())
, to_frame_ (frames.size())
, exposure_ (frames.size())
, noise_{0.0, 0.0, 0.0, 0.0, {}}
{
  labels_[pairs.reference()] = segments.labels();
  to_frame_[pairs.reference()].resize (segments.size());
}

void
WindowStart::run (const RigidPose& guess, const std::vector<KnownStep>& known)
{
  linkSegments();
  for (const int direction : {1, -1}) {
    RigidPose start = direction > 0 || pairs_.reference() == pairs_.frames() - 1
                          ? guess
                          : RigidPose{};
    int before = pairs_.reference();
    int from = before;
    learnt_.reset();
    for (int to = from + direction; to >= 0 && to < pairs_.frames(); to += direction) {
      const auto step =
          std::find_if (known.begin(), known.end(), [&] (const KnownStep& k) {
            return k.from == from && k.to == to;
          });
      if (step != known.end())
        applyStep (*step);
      else if (!followStep (before, from, to))
        solveStep (from, to, start);
      if (to_frame_[to].empty())
        compose (from, to);
      start = dominantPose (steps_[pairs_.between (from, to)]);
      before = from;
      from = to;
    }
  }
}

/** With the time that is left. */
SolverParameters
WindowStart::solverOfRest() const
{
  SolverParameters solver = solver_;
  if (solver.max_seconds > 0.0) // 0 would be no limit
    solver.max_seconds = std::max (1e-6, clock_.secondsLeft());
  return solver;
}

/** The two-frame solution of two adjacent frames, with the segments carried so far. */
void
WindowStart::solveStep (int from, int to, const RigidPose& guess)
{
  carryTo (from);
  const FrameLevel& level = frames_[from].levels()[0];
  const std::vector<int> seen =
      labelsInUse (labels_[from], level.inverse_depth, segments_.size());
  Step& step = steps_[pairs_.between (from, to)];
  step.poses.assign (segments_.size(), guess);
  step.body.assign (segments_.size(), -1);
  if (seen.empty())
    return;
  const Oversegmentation carried =
      Oversegmentation::fromLabels (labels_[from], frames_[from]);
  const SolverParameters solver = solverOfRest();
  const std::vector<RgbdFrame> pair{frames_[from], frames_[to]};
  WindowSolve solve (pair, 0, carried, energy_, solver, {}, tuning_);
  solve.solve (guess, kFinestLevel);
  const MotionState found = solve.state().ofPair (0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    step.poses[seen[i]] = found.poseOf (static_cast<int> (i));
    step.body[seen[i]] = found.body_of[i];
  }
  if (from == pairs_.reference() && solve.scene().links.size() == links_.size())
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const bool one_body = step.body[links_[i].first] == step.body[links_[i].second];
      link_weights_[i] = one_body ? 1.0 : found.weights[i];
    }
  fillUnseen (step);
  takeNoise (solve.scene().noise);
  learnt_.reset();
  if (from == pairs_.reference() && frames_[from].hasIntensity()) // depth alone loses
    learn (solve);                                                // what it follows
  const BrightnessChange& change = solve.scene().change;
  light_changed_ = light_changed_ || change.local;
  exposure_[to].gain = change.gain * exposure_[from].gain;
  exposure_[to].offset = change.gain * exposure_[from].offset + change.offset;
}

/** The largest of all solves. */
void
WindowStart::takeNoise (const NoiseModel& noise)
{
  noise_.intensity = std::max (noise_.intensity, noise.intensity);
  noise_.inverse_depth = std::max (noise_.inverse_depth, noise.inverse_depth);
  noise_.areas.brightness = std::max (noise_.areas.brightness, noise.areas.brightness);
  noise_.areas.icp = std::max (noise_.areas.icp, noise.areas.icp);
  noise_.displacement = noise.displacement;
  noise_.relative_depth = noise.relative_depth;
}

void
WindowStart::applyStep (const KnownStep& known)
{
  Step& step = steps_[pairs_.between (known.from, known.to)];
  step.poses = known.poses;
  step.body.assign (segments_.size(), -1);
  for (int k = 0; k < segments_.size(); ++k)
    if (known.known[k])
      step.body[k] = k;
  fillUnseen (step);
}

void
WindowStart::linkSegments()
{
  links_ = linkNearestCentroids (centroids(), energy_.neighbors);
  link_weights_.assign (links_.size(), 0.5); // until a solve says more
}

/** Segments that are hidden in the step's first frame move with the neighbour that they
 * are connected to most strongly. */
void
WindowStart::fillUnseen (Step& step) const
{
  bool changed = true;
  while (changed) {
    changed = false;
    const std::vector<int> before = step.body;
    std::vector<double> best (before.size(), -1.0);
    for (std::size_t i = 0; i < links_.size(); ++i)
      for (const auto& [to, from] : {std::pair{links_[i].first, links_[i].second},
                                     std::pair{links_[i].second, links_[i].first}})
        if (before[to] < 0 && before[from] >= 0 && link_weights_[i] > best[to]) {
          best[to] = link_weights_[i];
          step.body[to] = before[from];
          step.poses[to] = step.poses[from];
          changed = true;
        }
  }
}

/** The pose that most segments share. */
RigidPose
WindowStart::dominantPose (const Step& step) const
{
  std::map<int, int> count;
  for (const int b : step.body)
    ++count[b];
  int best = 0;
  for (std::size_t k = 0; k < step.body.size(); ++k)
    if (count[step.body[k]] > count[step.body[best]])
      best = static_cast<int> (k);
  return step.poses[best];
}

std::vector<Eigen::Vector3d>
WindowStart::centroids() const
{
  const FrameLevel& level = frames_[pairs_.reference()].levels()[0];
  PointOptions options;
  options.max_per_segment = tuning_.window.centroid_samples;
  options.tuning = tuning_.segments.pixels;
  return groupPixels (level, segments_.labels(), segments_.size(), options).centroid;
}

/** A step's motions from the reference. */
void
WindowStart::compose (int from, int to)
{
  const Step& step = steps_[pairs_.between (from, to)];
  for (int k = 0; k < segments_.size(); ++k)
    to_frame_[to].push_back (step.poses[k] * to_frame_[from][k]);
}

/** The segments' places in a frame. */
void
WindowStart::carryTo (int frame)
{
  if (labels_[frame].empty())
    labels_[frame] = carryLabels (frames_[pairs_.reference()].levels()[0],
                                  segments_.labels(),
                                  MotionState::fromSegments (to_frame_[frame], 0),
                                  frames_[frame].levels()[0],
                                  noise_,
                                  tuning_.window.carrier);
}

/** Poses of a pair by concatenation, per segment. */
std::vector<RigidPose>
WindowStart::chainedPoses (int pair) const
{
  std::vector<bool> inverse;
  for (const FramePairs::Step& step : pairs_.chain (pair))
    inverse.push_back (step.inverse);
  std::vector<RigidPose> poses;
  for (int k = 0; k < segments_.size(); ++k) {
    std::vector<RigidPose> chain;
    for (const FramePairs::Step& step : pairs_.chain (pair))
      chain.push_back (steps_[step.pair].poses[k]);
    poses.push_back (concatenate (chain, inverse));
  }
  return poses;
}

WindowState
WindowStart::state() const
{
  WindowState state;
  state.body_of = commonBodies();
  if (!frames_[pairs_.reference()].hasIntensity()) // depth of single pairs tells little
    std::iota (state.body_of.begin(), state.body_of.end(), 0);
  state.weights.assign (links_.size(), 1.0);
  for (int p = 0; p < pairs_.count(); ++p) {
    const std::vector<RigidPose> of_segments = chainedPoses (p);
    state.poses.emplace_back();
    for (std::size_t k = 0; k < of_segments.size(); ++k)
      if (state.body_of[k] == static_cast<int> (state.poses.back().size()))
        state.poses.back().push_back (of_segments[k]);
  }
  return state;
}

} // namespace pcl_msf
