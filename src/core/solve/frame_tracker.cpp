// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/frame_tracker.h"

#include "core/segments/label_use.h"
#include "core/solve/window_solve.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace pcl_msf {

namespace {

bool
isShare (double value)
{
  return value >= 0.0 && value <= 1.0;
}

/** Motions between frames that the former window held, too. \param former per frame but
 * the new one, its place in that window \param origin per segment, its number there or
 * -1 */
std::vector<KnownStep>
knownSteps (const MultiframeSceneFlow& result,
            const std::vector<int>& former,
            const std::vector<int>& origin)
{
  std::vector<KnownStep> known;
  for (int k = 0; k + 1 < static_cast<int> (former.size()); ++k) {
    KnownStep step{k, k + 1, {}, {}};
    for (const int segment : origin) {
      step.known.push_back (segment >= 0);
      step.poses.push_back (segment >= 0
                                ? result.poseBetween (former[k], former[k + 1], segment)
                                : RigidPose{});
    }
    known.push_back (std::move (step));
  }
  return known;
}

} // namespace

bool
TrackerParameters::isValid (std::string* why) const
{
  std::string problem;
  if (window != 0 && (window < 2 || window > 16))
    problem = "window must be 0 or in [2, 16]";
  else if (merge_segments && window == 0)
    problem = "merge_segments needs frames that are solved jointly: set window";
  else if (!isShare (least_visible))
    problem = "least_visible must be in [0, 1]";
  else if (!isShare (least_explained))
    problem = "least_explained must be in [0, 1]";
  if (why && !problem.empty())
    *why = problem;
  return problem.empty();
}

FrameTracker::FrameTracker (const TrackerParameters& tracker,
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
FrameTracker::requireValid() const
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
FrameTracker::reset()
{
  *this = FrameTracker (tracker_, segmentation_, energy_, solver_, multiframe_);
}

const SceneFlow&
FrameTracker::sceneFlow() const
{
  static const SceneFlow none{};
  return result_.frames.empty() ? none : result_.frames.back();
}

RigidPose
FrameTracker::cameraPose() const
{
  return world_from_reference_ * sceneFlow().dominant_motion.inverse();
}

/** Share of the reference's segments' points that the newest frame shows. */
double
FrameTracker::visibleShare() const
{
  int points = 0;
  int seen = 0;
  for (const SegmentMotion& segment : sceneFlow().segments) {
    points += segment.points;
    seen += segment.visible_points;
  }
  return static_cast<double> (seen) / std::max (1, points);
}

/** Per segment, the first one of those that share all its motions. */
std::vector<int>
FrameTracker::mergedLabels() const
{
  std::vector<int> merged (segments_.size());
  std::map<std::vector<double>, int> first_with;
  for (int k = 0; k < segments_.size(); ++k) {
    std::vector<double> key;
    for (const PairMotion& motion : result_.motions)
      key.insert (key.end(),
                  motion.segments[k].parameters.begin(),
                  motion.segments[k].parameters.end());
    merged[k] = first_with.emplace (key, k).first->second;
  }
  return merged;
}

/** The window as it is. */
FrameTracker::Window
FrameTracker::grow() const
{
  Window next{frames_, indices_, {}, segments_, {}, world_from_reference_};
  next.former.resize (frames_.size());
  std::iota (next.former.begin(), next.former.end(), 0);
  next.origin.resize (segments_.size());
  std::iota (next.origin.begin(), next.origin.end(), 0);
  return next;
}

/** The window without the oldest frame beside its reference, which stays. */
FrameTracker::Window
FrameTracker::slide() const
{
  Window next = grow();
  next.frames.erase (next.frames.begin() + 1);
  next.indices.erase (next.indices.begin() + 1);
  next.former.erase (next.former.begin() + 1);
  if (!tracker_.merge_segments || tracker_.window == 0)
    return next;
  const std::vector<int> merged = mergedLabels();
  cv::Mat labels = segments_.labels().clone();
  labels.forEach<int> ([&merged] (int& label, const int*) {
    label = label >= 0 ? merged[label] : label;
  });
  const RgbdFrame& reference = frames_.front();
  next.segments = Oversegmentation::fromLabels (labels, reference);
  next.origin = labelsInOrder (labels, reference.levels()[0].inverse_depth);
  return next;
}

/** The newest frame as the reference of a window of its own. */
FrameTracker::Window
FrameTracker::beginAnew() const
{
  Window next{
      {frames_.back()}, {indices_.back()}, {frames() - 1}, {}, {}, cameraPose()};
  next.segments =
      Oversegmentation::fromFrame (next.frames.front(), segmentation_, solver_.threads);
  next.origin.assign (next.segments.size(), -1);
  return next;
}

void
FrameTracker::add (const RgbdFrame& frame)
{
  if (frame.empty())
    throw InvalidInput ("the frame is empty");
  if (frames_.empty()) {
    segments_ = Oversegmentation::fromFrame (frame, segmentation_, solver_.threads);
    frames_.push_back (frame);
    indices_.push_back (0);
    return;
  }
  SceneFlowEstimator (energy_, solver_)
      .requireUsable (frames_.front(), frame, segments_);
  if (tracker_.window == 0) {
    Window window = !explained_ ? beginAnew() : frames() > 1 ? slide() : grow();
    window.frames.push_back (frame);
    window.indices.push_back (indices_.back() + 1);
    follow (std::move (window));
    return;
  }
  const bool full = frames() == tracker_.window;
  Window window = !explained_ || (full && frames() == 2) ? beginAnew()
                  : full                                 ? slide()
                                                         : grow();
  window.frames.push_back (frame);
  window.indices.push_back (indices_.back() + 1);
  solve (std::move (window));
}

/** Solves a window; what the last one knew of its motions is the start. */
void
FrameTracker::solve (Window window)
{
  const std::vector<RgbdFrame> frames (window.frames.begin(), window.frames.end());
  WindowSolve joint (
      frames, 0, window.segments, energy_, solver_, multiframe_, currentTuning());
  if (!tracker_.dense)
    joint.leaveImagesOut();
  const RigidPose last_step =
      result_.frames.size() < 2
          ? RigidPose{}
          : sceneFlow().dominant_motion *
                result_.frames[result_.frames.size() - 2].dominant_motion.inverse();
  MultiframeSceneFlow result =
      joint.run (last_step, knownSteps (result_, window.former, window.origin));
  const double covered =
      labelledShare (joint.labelsIn (static_cast<int> (frames.size()) - 1),
                     frames.back().levels()[0].inverse_depth);
  adopt (std::move (window), std::move (result));
  explained_ = explained_ && covered >= tracker_.least_explained;
}

/** A solved window becomes the present one. */
void
FrameTracker::adopt (Window window, MultiframeSceneFlow result)
{
  result_ = std::move (result);
  frames_ = std::move (window.frames);
  indices_ = std::move (window.indices);
  segments_ = std::move (window.segments);
  world_from_reference_ = window.world_from_reference;
  explained_ = visibleShare() >= tracker_.least_visible;
}

} // namespace pcl_msf
