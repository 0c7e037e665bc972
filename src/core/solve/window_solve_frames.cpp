// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include "core/solve/window_solve.h"
#include "core/window/depth_fusion.h"
#include "core/window/exposure.h"
#include "core/window/segment_carrier.h"

#include <algorithm>
#include <memory>
#include <utility>

/* The levels of WindowSolve, by what its present poses tell about the frames. */
namespace pcl_msf {

cv::Mat
WindowSolve::labelsIn (int frame, int level) const
{
  cv::Mat labels = segments_.labels();
  for (int i = 0; i < level; ++i)
    labels = halveLabels (labels);
  return pcl_msf::carryLabels (frames_[pairs_.reference()].levels()[level],
                               labels,
                               state_.ofPair (pairs_.fromReference (frame)),
                               frames_[frame].levels()[level],
                               scene_.noise,
                               scene_.tuning.window.carrier);
}

/** Per frame that a pair starts from, at a level. */
std::vector<cv::Mat>
WindowSolve::carryLabels (int level) const
{
  const int reference = pairs_.reference();
  std::vector<cv::Mat> labels (frames_.size());
  labels[reference] = segments_.labels();
  std::vector<int> sources;
  for (const int p : scene_.used)
    if (pairs_[p].from != reference)
      sources.push_back (pairs_[p].from);
  std::sort (sources.begin(), sources.end());
  sources.erase (std::unique (sources.begin(), sources.end()), sources.end());
  const int count = static_cast<int> (sources.size());
  parallelFor (scene_.threads, count, 1, [&] (int i) {
    labels[sources[i]] = labelsIn (sources[i]);
  });
  for (int i = 0; i < level; ++i)
    for (cv::Mat& image : labels)
      if (!image.empty())
        image = halveLabels (image);
  return labels;
}

/** Compares every frame's exposure with the reference's, at the present poses. */
void
WindowSolve::fitExposures (int at, const cv::Mat& labels)
{
  const int reference = pairs_.reference();
  PointOptions options = pointOptions (scene_, at);
  options.max_per_segment = scene_.tuning.window.falloff.samples;
  const SegmentPixels points =
      groupPixels (frames_[reference].levels()[at], labels, scene_.segments, options);
  std::vector<MatchedIntensities> matches (frames_.size());
  parallelFor (scene_.threads, pairs_.frames(), 1, [&] (int f) {
    if (f == reference)
      return;
    matches[f] = matchIntensities (
        points, state_.ofPair (pairs_.fromReference (f)), frames_[f].levels()[at]);
    scene_.exposure[f] = fitExposureChange (
        matches[f].reference, matches[f].current, scene_.tuning.frame.brightness);
  });
  scene_.falloff = fitFalloff (matches, scene_.exposure, scene_.tuning.window.falloff);
}

/** All frames' measurements of the reference's points in one. */
void
WindowSolve::fuseDepth()
{
  const int reference = pairs_.reference();
  DepthFusion fusion (frames_[reference].levels()[0], segments_.labels());
  for (int f = 0; f < pairs_.frames(); ++f)
    if (f != reference)
      fusion.add ({&frames_[f].levels()[0], state_.ofPair (pairs_.fromReference (f))},
                  scene_.noise,
                  scene_.tuning.window.fusion,
                  scene_.threads);
  scene_.fused_depth = fusion.average();
}

/** A round's level, with segments carried by the present poses. */
void
WindowSolve::enterLevel (const Round& round)
{
  if (upcoming_.has (round.level)) {
    enterPrepared (round.level, upcoming_.take (round.level));
    return;
  }
  const std::vector<cv::Mat> labels = carryLabels (round.level);
  if (!isPair())
    fitExposures (round.level, labels[pairs_.reference()]);
  if (round.fuse)
    fuseDepth();
  const PointOptions options = pointOptions (scene_, round.level);
  enterPrepared (round.level,
                 prepareLevel (scene_, round.level, labels, options, needsOf (round)));
}

LevelNeeds
WindowSolve::needsOf (const Round& round) const
{
  return {dense_ && round.results, isPair() && !follows_ && round.level == 0};
}

/** Of two frames, level 1 tells what the finest one's brightness is worth. */
void
WindowSolve::enterPrepared (int level, LevelPoints points)
{
  if (isPair() && level == 0) {
    scene_.brightness_area = brightness_area_;
    leaveMeansOut (scene_, level, points);
  }
  level_ = std::make_unique<WindowLevel> (scene_, level, std::move (points), energy_);
}

/** Of two frames, points of a level depend on nothing that the solve finds: another
 * thread makes those of all later levels, while this one has much to do alone. */
void
WindowSolve::prepareUpcoming (const std::vector<Round>& later)
{
  if (!isPair() || scene_.threads == 1)
    return;
  std::vector<UpcomingLevels::Request> requests;
  for (const Round& round : later)
    if (round.anew) {
      requests.push_back ({carryLabels (round.level),
                           pointOptions (scene_, round.level),
                           needsOf (round)});
      requests.back().options.threads = 1;
    }
  if (!requests.empty())
    upcoming_.begin (scene_, std::move (requests));
}

} // namespace pcl_msf
