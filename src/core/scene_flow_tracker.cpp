// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/label_refill.h"
#include "core/multi_frame_solve.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <pcl_msf/scene_flow_tracker.h>

#include <algorithm>
#include <map>

namespace pcl_msf {

namespace {

constexpr double kMostSegments = 1.5; // of a fresh segmentation's

bool
isShare (double value)
{
  return value >= 0.0 && value <= 1.0;
}

} // namespace

bool
TrackerParameters::isValid (std::string* why) const
{
  std::string problem;
  if (window < 2 || window > 16)
    problem = "window must be in [2, 16]";
  else if (!isShare (least_visible))
    problem = "least_visible must be in [0, 1]";
  else if (!isShare (least_kept))
    problem = "least_kept must be in [0, 1]";
  if (why && !problem.empty())
    *why = problem;
  return problem.empty();
}

SceneFlowTracker::SceneFlowTracker (const TrackerParameters& tracker,
                                    const SegmentationParameters& segmentation,
                                    const EnergyParameters& energy,
                                    const SolverParameters& solver,
                                    const MultiframeParameters& multiframe)
: tracker_ (tracker)
, segmentation_ (segmentation)
, energy_ (energy)
, solver_ (solver)
, multiframe_ (multiframe)
{
  requireValid();
}

void
SceneFlowTracker::requireValid() const
{
  std::string why;
  if (!tracker_.isValid (&why))
    throw InvalidInput ("tracker parameters: " + why);
  if (!segmentation_.isValid (&why))
    throw InvalidInput ("segmentation parameters: " + why);
  if (!energy_.isValid (&why))
    throw InvalidInput ("energy parameters: " + why);
  if (!solver_.isValid (&why))
    throw InvalidInput ("solver parameters: " + why);
  if (!multiframe_.isValid (&why))
    throw InvalidInput ("multiframe parameters: " + why);
}

void
SceneFlowTracker::reset()
{
  *this = SceneFlowTracker (tracker_, segmentation_, energy_, solver_, multiframe_);
}

const SceneFlow&
SceneFlowTracker::sceneFlow() const
{
  static const SceneFlow none;
  return result_.frames.empty() ? none : result_.frames.back();
}

RigidPose
SceneFlowTracker::cameraPose() const
{
  return world_from_reference_ * sceneFlow().dominant_motion.inverse();
}

/** Share of the reference's points that the newest frame shows. */
double
SceneFlowTracker::visibleShare() const
{
  const cv::Mat& visibility = sceneFlow().visibility;
  const double seen = cv::countNonZero (visibility == static_cast<int> (Visible));
  return seen / std::max (1, cv::countNonZero (visibility));
}

/** Per segment, the first one of those that share all its motions. */
std::vector<int>
SceneFlowTracker::mergedLabels() const
{
  std::vector<int> merged (segments_.size());
  std::map<std::vector<double>, int> first_with;
  for (int k = 0; k < segments_.size(); ++k) {
    std::vector<double> key;
    for (const PairMotion& motion : result_.motions)
      key.insert (key.end(),
                  motion.segments[k].parameters.begin(),
                  motion.segments[k].parameters.end());
    merged[k] = tracker_.merge_segments ? first_with.emplace (key, k).first->second : k;
  }
  return merged;
}

/** The window without its oldest frame; its segments, carried to the next one. */
SceneFlowTracker::Window
SceneFlowTracker::slide() const
{
  Window next{frames_, {}, {}, {}, first_ + 1};
  next.frames.pop_front();
  next.world_from_reference =
      world_from_reference_ * result_.frames[1].dominant_motion.inverse();
  const RgbdFrame& reference = next.frames.front();
  const cv::Mat& depth = reference.levels()[0].inverse_depth;
  const Oversegmentation fresh = Oversegmentation::fromFrame (reference, segmentation_);
  const std::vector<int> merged = mergedLabels();
  cv::Mat labels = carried_.clone();
  labels.forEach<int> ([&merged] (int& label, const int*) {
    label = label >= 0 ? merged[label] : label;
  });
  labels = fillWithFresh (labels, fresh, segments_.size());
  const std::vector<int> order = labelsInOrder (labels, depth);
  const bool explained = labelledShare (carried_, depth) >= tracker_.least_kept &&
                         order.size() <= kMostSegments * fresh.size();
  for (const int label : order)
    next.origin.push_back (label < segments_.size() ? label : -1);
  if (!explained)
    next.origin.assign (fresh.size(), -1);
  next.segments = explained ? Oversegmentation::fromLabels (labels, reference) : fresh;
  return next;
}

/** The newest frame as the reference of a window of its own. */
SceneFlowTracker::Window
SceneFlowTracker::beginAnew() const
{
  Window next{{frames_.back()}, {}, {}, cameraPose(), first_ + frames() - 1};
  next.segments = Oversegmentation::fromFrame (next.frames.front(), segmentation_);
  next.origin.assign (next.segments.size(), -1);
  return next;
}

void
SceneFlowTracker::add (const RgbdFrame& frame)
{
  if (frames_.empty()) {
    if (frame.empty())
      throw InvalidInput ("the frame is empty");
    segments_ = Oversegmentation::fromFrame (frame, segmentation_);
    frames_.push_back (frame);
    return;
  }
  SceneFlowEstimator (energy_, solver_)
      .requireUsable (frames_.front(), frame, segments_);
  Window window{frames_, segments_, {}, world_from_reference_, first_};
  for (int k = 0; k < segments_.size(); ++k)
    window.origin.push_back (k);
  if (!result_.frames.empty() && visibleShare() < tracker_.least_visible)
    window = beginAnew();
  else if (frames() == tracker_.window && frames() == 2)
    window = beginAnew();
  else if (frames() == tracker_.window)
    window = slide();
  window.frames.push_back (frame);
  solve (std::move (window));
}

/** Solves a window; what the last one knew of its motions is the start. */
void
SceneFlowTracker::solve (Window window)
{
  const int shift = static_cast<int> (window.first - first_);
  const int count = static_cast<int> (window.frames.size());
  std::vector<KnownStep> known;
  for (int k = 0; k + 2 < count; ++k) {
    KnownStep step{k, k + 1, {}, {}};
    for (const int origin : window.origin) {
      step.known.push_back (origin >= 0);
      step.poses.push_back (origin >= 0
                                ? result_.poseBetween (k + shift, k + 1 + shift, origin)
                                : RigidPose{});
    }
    if (std::count (step.known.begin(), step.known.end(), 1) > 0)
      known.push_back (std::move (step));
  }
  const std::vector<RgbdFrame> frames (window.frames.begin(), window.frames.end());
  MultiFrameSolve joint (frames, 0, window.segments, energy_, solver_, multiframe_);
  const RigidPose last_step =
      result_.frames.size() < 2
          ? RigidPose{}
          : sceneFlow().dominant_motion *
                result_.frames[result_.frames.size() - 2].dominant_motion.inverse();
  result_ = joint.run (last_step, known);
  carried_ = joint.labelsIn (1);
  frames_ = std::move (window.frames);
  segments_ = window.segments;
  world_from_reference_ = window.world_from_reference;
  first_ = window.first;
}

} // namespace pcl_msf
