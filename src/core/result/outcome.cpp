// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/outcome.h"

#include "core/base/number_text.h"
#include "core/result/overlap.h"

#include <algorithm>
#include <limits>

namespace pcl_msf {

namespace {

constexpr int kFewPoints = 20;          // three residuals per parameter of a pose
constexpr double kFew = 0.02;           // share of the moved points
constexpr double kHardlyAny = 0.15;     // share of those that land on depth
constexpr double kMostly = 0.5;         // share of the points with depth
constexpr double kNoSurface = 0.1;      // noise as a share of the mean inverse depth
constexpr double kLeastContrast = 0.02; // standard deviation of the intensity
constexpr int kPatches = 20;            // whose median tells something
// Median correlation of texture, the middle between what recordings show: of one place
// 0.67 and more, also where most things move or are followed wrongly; of different ones
// 0.26 and less.
constexpr double kSamePlace = 0.47;
// Where texture tells nothing. Of 117 pairs of one place, taken without colour, 75 % or
// more of what lands on depth is found. Of 39 unrelated ones, to which nothing else
// objects, 36 find less: below kFewFound, or with 11 % of the rest in front.
constexpr double kFound = 0.7;
constexpr double kInFront = 0.06; // of what is found or in front
constexpr double kFewFound = 0.3; // share of those that land; the others may be hidden

bool
isDetermined (const SceneFlow& flow)
{
  return std::any_of (
      flow.segments.begin(), flow.segments.end(), [] (const SegmentMotion& s) {
        return s.status != MotionStatus::Undetermined;
      });
}

/** Neighbouring measurements have nothing to do with each other. */
bool
isNoise (const RgbdFrame& frame)
{
  const cv::Mat& inverse_depth = frame.levels()[0].inverse_depth;
  const double mean = cv::mean (inverse_depth, inverse_depth > 0.0f)[0];
  return frame.inverseDepthNoise() > kNoSurface * mean;
}

/** As through a covered lens: hardly any contrast. */
bool
isBlank (const RgbdFrame& frame)
{
  if (!frame.hasIntensity())
    return false;
  cv::Scalar mean;
  cv::Scalar spread;
  cv::meanStdDev (frame.levels()[0].intensity, mean, spread);
  return spread[0] < kLeastContrast;
}

/** Nothing is known: no motion is shown. */
void
forgetMotion (SceneFlow& flow)
{
  const auto unknown = cv::Scalar::all (std::numeric_limits<double>::quiet_NaN());
  flow.displacement.setTo (unknown);
  flow.flow.setTo (unknown);
  flow.visibility.setTo (Unknown, flow.visibility != static_cast<int> (NoDepth));
  for (SegmentMotion& segment : flow.segments) {
    segment.status = MotionStatus::Undetermined;
    segment.visible_points = 0;
  }
  flow.dominant_body = -1;
  flow.dominant_motion = RigidPose();
}

std::string
percent (double part, double whole)
{
  return std::to_string (static_cast<int> (100.0 * part / std::max (1.0, whole))) +
         " %";
}

Judgement
judgeOverlap (const Overlap& o)
{
  const double few = std::max<double> (kFewPoints, kFew * o.moved);
  if (o.landed < few)
    return {StopReason::NothingDetermined,
            "no motion could be determined: only " + std::to_string (o.landed) +
                " of " + std::to_string (o.moved) +
                " points land where the other frame has depth: give frames that "
                "overlap and more depth"};
  if (o.found < few || o.found < kHardlyAny * o.landed)
    return {StopReason::DifferentPlaces,
            "the frames show different places: only " + percent (o.found, o.landed) +
                " of the points that land on the other frame's depth are found there; "
                "give frames that overlap, or a guess"};
  return {};
}

/** Of shape alone. A wall that fits hides nothing; what stands before the other frame's
 * surfaces contradicts them. */
Judgement
judgeShape (const Overlap& o, int in_front)
{
  const bool contradicted =
      o.found < kFound * o.landed && in_front > kInFront * (o.found + in_front);
  if (!contradicted && o.found >= kFewFound * o.landed)
    return {};
  return {StopReason::DifferentPlaces,
          "the frames show different places: only " + percent (o.found, o.landed) +
              " of the points that land on the other frame's depth are found there, " +
              percent (in_front, o.landed) +
              " would hide what it sees, and no texture tells more; give frames that "
              "overlap, colour, or a guess"};
}

Judgement
judgeTexture (const Likeness& texture)
{
  if (texture.median >= kSamePlace)
    return {};
  return {StopReason::DifferentPlaces,
          "the frames show different places: the texture found correlates with the "
          "reference's by only " +
              fixedText (texture.median, 2) + " (median; the same place by " +
              fixedText (kSamePlace, 2) +
              " or more); give frames that overlap, or a guess"};
}

} // namespace

StopReason
endOfSolve (bool settled, bool failed)
{
  if (failed)
    return StopReason::NumericalFailure;
  return settled ? StopReason::Converged : StopReason::IterationLimit;
}

Judgement
judgeMotion (const RgbdFrame& reference,
             const RgbdFrame& current,
             double intensity_noise,
             SceneFlow& flow)
{
  const Judgement nothing{StopReason::NothingDetermined,
                          "no segment's motion could be determined: a frame shows too "
                          "little texture and shape (is the lens covered?), or they "
                          "show nothing in common"};
  Judgement judgement = nothing;
  if (isDetermined (flow)) {
    const Overlap overlap = measureOverlap (current, flow);
    judgement = judgeOverlap (overlap);
    if (judgement.objection == StopReason::NotRun) {
      const Likeness texture =
          compareTexture (reference, current, intensity_noise, flow);
      judgement = texture.patches >= kPatches
                      ? judgeTexture (texture)
                      : judgeShape (overlap, countInFront (reference, current, flow));
    }
    if (judgement.objection == StopReason::NotRun &&
        (isNoise (reference) || isNoise (current)))
      judgement = {StopReason::DifferentPlaces,
                   "the frames show different places: the depth of one is noise, in "
                   "which no surface is found"};
    // A blank frame shows no other one's texture: then its depth must tell nearly all.
    const bool lost_texture = isBlank (reference) != isBlank (current);
    if (lost_texture && overlap.found < kMostly * overlap.moved)
      judgement = nothing;
    // The little that seemed determined is not found either.
    if (judgement.objection == StopReason::DifferentPlaces &&
        (overlap.moved < kMostly * overlap.points || isBlank (reference) ||
         isBlank (current)))
      judgement = nothing;
  }
  if (judgement.objection == StopReason::NothingDetermined)
    forgetMotion (flow);
  return judgement;
}

void
conclude (StopReason cut_short,
          const std::vector<Judgement>& judgements,
          Report& report)
{
  const bool ran = cut_short == StopReason::NotRun &&
                   report.stop_reason != StopReason::NumericalFailure;
  if (cut_short != StopReason::NotRun)
    report.stop_reason = cut_short;
  if (report.stop_reason == StopReason::NumericalFailure)
    report.message = "the solver could not make a step";
  for (const Judgement& j : judgements) {
    if (j.objection == StopReason::NotRun)
      continue;
    if (ran)
      report.stop_reason = j.objection;
    report.message =
        (j.frame < 0 ? "" : "frame " + std::to_string (j.frame) + " of the window: ") +
        j.why;
    break;
  }
  report.converged = report.stop_reason == StopReason::Converged ||
                     report.stop_reason == StopReason::IterationLimit;
}

} // namespace pcl_msf
