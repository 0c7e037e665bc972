// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include "core/segments/label_use.h"
#include "core/solve/frame_tracker.h"
#include "core/solve/window_solve.h"
#include "core/window/depth_fusion.h"

#include <algorithm>
#include <utility>

/* FrameTracker that follows the reference frame by frame. */
namespace pcl_msf {

/** What the last frame told. */
struct FrameTracker::Following {
  WindowState state;             ///< of the reference and the newest frame
  std::vector<RigidPose> before; ///< per segment, to the frame before that one
  std::vector<SegmentLink> links;
  CorrelationAreas areas;
  double brightness_area{1.0}; ///< see WindowScene
  std::vector<double> costs;   ///< per segment
  int level{0};                ///< of the labels
  cv::Mat labels;              ///< of the segments, carried to the newest frame
  DepthFusion depth;           ///< of the reference

  /** Motion of a segment between the last two frames. */
  RigidPose
  lastStep (int segment) const
  {
    const RigidPose& now = state.poses[0][state.body_of[segment]];
    return before.empty() ? now : now * before[segment].inverse();
  }
};

namespace {

/** Per body, its first segment. */
std::vector<int>
firstSegments (const WindowState& state)
{
  std::vector<int> first (state.bodies(), -1);
  for (std::size_t k = 0; k < state.body_of.size(); ++k)
    if (first[state.body_of[k]] < 0)
      first[state.body_of[k]] = static_cast<int> (k);
  return first;
}

/** Per new segment, the label that most of its points bear in an image; -1 = none. */
std::vector<int>
mostFrequent (const cv::Mat& labels, int segments, const cv::Mat& image, int values)
{
  cv::Mat count (segments, values, CV_32SC1, cv::Scalar (0));
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (labels.at<int> (y, x) >= 0 && image.at<int> (y, x) >= 0)
        ++count.at<int> (labels.at<int> (y, x), image.at<int> (y, x));
  std::vector<int> result (segments, -1);
  for (int k = 0; k < segments; ++k) {
    const int* row = count.ptr<int> (k);
    const int* most = std::max_element (row, row + values);
    result[k] = *most > 0 ? static_cast<int> (most - row) : -1;
  }
  return result;
}

} // namespace

/** The bodies as they were, where they would be at their last speed or at rest. */
FollowedMotion
FrameTracker::predictMotion() const
{
  const Following& last = *following_;
  FollowedMotion motion{last.state.body_of,
                        {{}, {}},
                        last.links,
                        last.areas,
                        last.brightness_area,
                        last.costs,
                        {}};
  for (const int k : firstSegments (last.state)) {
    const RigidPose& pose = last.state.poses[0][last.state.body_of[k]];
    motion.guesses[0].push_back (last.lastStep (k) * pose);
    motion.guesses[1].push_back (pose);
  }
  motion.depth = last.depth.average();
  return motion;
}

/** The same for a new reference, whose segments belong to the bodies that they show. */
FollowedMotion
FrameTracker::predictAnew (const Oversegmentation& segments) const
{
  const Following& last = *following_;
  cv::Mat labels = segments.labels();
  for (int i = 0; i < last.level; ++i)
    labels = halveLabels (labels);
  const std::vector<int> former =
      mostFrequent (labels,
                    segments.size(),
                    last.labels,
                    static_cast<int> (last.state.body_of.size()));
  FollowedMotion motion{{}, {{}, {}}, {}, last.areas, last.brightness_area, {}, {}};
  for (const int k : firstSegments (last.state)) {
    motion.guesses[0].push_back (last.lastStep (k));
    motion.guesses[1].push_back (RigidPose{});
  }
  const int largest = last.state.largestBody();
  for (const int k : former) {
    motion.body_of.push_back (k < 0 ? largest : last.state.body_of[k]);
    motion.costs.push_back (k < 0 ? 0.0 : last.costs[k]);
  }
  return motion;
}

/** What a solve from the window's reference tells about the next frame. */
std::shared_ptr<FrameTracker::Following>
FrameTracker::learn (const WindowSolve& solve, const Window& window) const
{
  const RgbdFrame& newest = window.frames.back();
  const bool same_reference = following_ && window.indices.front() == indices_.front();
  auto now = std::make_shared<Following>();
  now->state = solve.state();
  now->links = solve.scene().links;
  now->areas = solve.scene().noise.areas;
  now->brightness_area = solve.scene().brightness_area;
  now->costs = solve.fit();
  now->level = std::min<int> (1, static_cast<int> (newest.levels().size()) - 1);
  now->labels = solve.labelsIn (1, now->level);
  if (same_reference)
    for (const int body : following_->state.body_of)
      now->before.push_back (following_->state.poses[0][body]);
  now->depth = same_reference ? following_->depth
                              : DepthFusion (window.frames.front().levels()[0],
                                             window.segments.labels());
  now->depth.add ({&newest.levels()[0], now->state.ofPair (0)},
                  solve.scene().noise,
                  currentTuning().window.fusion,
                  threadCount (solver_.threads));
  return now;
}

/** Solves from the reference to the window's newest frame; a window of another
 * reference than the last one begins anew. A frame that the prediction does not lead to
 * is looked for as a first one. A frame that shows nothing is passed over; where others
 * are lost, the next one begins anew without a prediction. */
void
FrameTracker::follow (Window window)
{
  const bool anew = window.indices.front() != indices_.front();
  const std::vector<RgbdFrame> frames (window.frames.begin(), window.frames.end());
  std::unique_ptr<WindowSolve> solve;
  MultiframeSceneFlow result;
  const auto run = [&] (bool predicted) {
    solve = std::make_unique<WindowSolve> (
        frames, 0, window.segments, energy_, solver_, multiframe_, currentTuning());
    solve->keepSegmentsApart();
    if (!tracker_.dense)
      solve->leaveImagesOut();
    if (predicted)
      solve->follow (anew ? predictAnew (window.segments) : predictMotion());
    result = solve->run (anew ? RigidPose{} : sceneFlow().dominant_motion);
    return result.frames.back().report.stop_reason;
  };
  const StopReason end = run (following_ != nullptr);
  if (solve->follows() && end == StopReason::DifferentPlaces)
    run (false);
  std::shared_ptr<const Following> now = learn (*solve, window);
  const Report& report = result.frames.back().report;
  const bool known = report.converged;
  const bool nothing_seen = report.stop_reason == StopReason::NothingDetermined;
  const double covered =
      labelledShare (now->labels, frames[1].levels()[now->level].inverse_depth);
  adopt (std::move (window), std::move (result));
  explained_ = (explained_ && known && covered >= tracker_.least_explained) ||
               (nothing_seen && !anew);
  if (known)
    following_ = std::move (now);
  else if (!nothing_seen)
    following_.reset();
}

} // namespace pcl_msf
