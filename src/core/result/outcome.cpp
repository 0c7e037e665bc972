// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/outcome.h"

#include "core/base/number_text.h"
#include "core/result/overlap.h"

#include <algorithm>
#include <limits>

namespace pcl_msf {

namespace {

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
isNoise (const RgbdFrame& frame, const OutcomeTuning& tuning)
{
  const cv::Mat& inverse_depth = frame.levels()[0].inverse_depth;
  const double mean = cv::mean (inverse_depth, inverse_depth > 0.0f)[0];
  return frame.inverseDepthNoise() > tuning.no_surface * mean;
}

/** As through a covered lens: hardly any contrast. */
bool
isBlank (const RgbdFrame& frame, const OutcomeTuning& tuning)
{
  if (!frame.hasIntensity())
    return false;
  cv::Scalar mean;
  cv::Scalar spread;
  cv::meanStdDev (frame.levels()[0].intensity, mean, spread);
  return spread[0] < tuning.least_contrast;
}

/** Nothing is known: no motion is shown. */
void
clearMotion (SceneFlow& flow)
{
  const auto unknown = cv::Scalar::all (std::numeric_limits<double>::quiet_NaN());
  flow.displacement.setTo (unknown);
  flow.flow.setTo (unknown);
  flow.visibility.setTo (pixelValue (Visibility::Unknown),
                         flow.visibility != pixelValue (Visibility::NoDepth));
  for (SegmentMotion& segment : flow.segments) {
    segment.status = MotionStatus::Undetermined;
    segment.visible_points = 0;
  }
  flow.dominant_group = -1;
  flow.dominant_motion = RigidPose();
}

std::string
percent (double part, double whole)
{
  return std::to_string (static_cast<int> (100.0 * part / std::max (1.0, whole))) +
         " %";
}

Judgement
judgeOverlap (const Overlap& o, const OutcomeTuning& tuning)
{
  const double few = std::max<double> (tuning.few_points, tuning.few * o.moved);
  if (o.landed < few)
    return {StopReason::NothingDetermined,
            "no motion could be determined: only " + std::to_string (o.landed) +
                " of " + std::to_string (o.moved) +
                " points land where the other frame has depth: give frames that "
                "overlap and more depth"};
  if (o.found < few || o.found < tuning.hardly_any * o.landed)
    return {StopReason::DifferentPlaces,
            "the frames show different places: only " + percent (o.found, o.landed) +
                " of the points that land on the other frame's depth are found there; "
                "give frames that overlap, or a guess"};
  return {};
}

/** Of shape alone. A wall that fits hides nothing; what stands before the other frame's
 * surfaces contradicts them. */
Judgement
judgeShape (const Overlap& o, int in_front, const OutcomeTuning& tuning)
{
  const bool contradicted = o.found < tuning.found * o.landed &&
                            in_front > tuning.in_front * (o.found + in_front);
  if (!contradicted && o.found >= tuning.few_found * o.landed)
    return {};
  return {StopReason::DifferentPlaces,
          "the frames show different places: only " + percent (o.found, o.landed) +
              " of the points that land on the other frame's depth are found there, " +
              percent (in_front, o.landed) +
              " would hide what it sees, and no texture tells more; give frames that "
              "overlap, colour, or a guess"};
}

Judgement
judgeTexture (const Likeness& texture, const OutcomeTuning& tuning)
{
  if (texture.median >= tuning.same_place)
    return {};
  return {StopReason::DifferentPlaces,
          "the frames show different places: the texture found correlates with the "
          "reference's by only " +
              fixedText (texture.median, 2) + " (median; the same place by " +
              fixedText (tuning.same_place, 2) +
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
             const OutcomeTuning& tuning,
             int threads,
             SceneFlow& flow)
{
  const Judgement nothing{StopReason::NothingDetermined,
                          "no segment's motion could be determined: a frame shows too "
                          "little texture and shape (is the lens covered?), or they "
                          "show nothing in common"};
  Judgement judgement = nothing;
  if (isDetermined (flow)) {
    const Overlap overlap = measureOverlap (current, flow, threads);
    judgement = judgeOverlap (overlap, tuning);
    if (judgement.failure == StopReason::NotRun) {
      const Likeness texture =
          compareTexture (reference, current, intensity_noise, tuning, threads, flow);
      judgement = texture.patches >= tuning.patches
                      ? judgeTexture (texture, tuning)
                      : judgeShape (overlap,
                                    countInFront (reference, current, tuning, flow),
                                    tuning);
    }
    if (judgement.failure == StopReason::NotRun &&
        (isNoise (reference, tuning) || isNoise (current, tuning)))
      judgement = {StopReason::DifferentPlaces,
                   "the frames show different places: the depth of one is noise, in "
                   "which no surface is found"};
    // A blank frame shows no other one's texture: then its depth must tell nearly all.
    if (overlap.found < tuning.mostly * overlap.moved &&
        isBlank (reference, tuning) != isBlank (current, tuning))
      judgement = nothing;
    // The little that seemed determined is not found either.
    if (judgement.failure == StopReason::DifferentPlaces &&
        (overlap.moved < tuning.mostly * overlap.points ||
         isBlank (reference, tuning) || isBlank (current, tuning)))
      judgement = nothing;
  }
  if (judgement.failure == StopReason::NothingDetermined)
    clearMotion (flow);
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
    if (j.failure == StopReason::NotRun)
      continue;
    if (ran)
      report.stop_reason = j.failure;
    report.message =
        (j.frame < 0 ? "" : "frame " + std::to_string (j.frame) + " of the window: ") +
        j.why;
    break;
  }
  report.converged = report.stop_reason == StopReason::Converged ||
                     report.stop_reason == StopReason::IterationLimit;
}

} // namespace pcl_msf
