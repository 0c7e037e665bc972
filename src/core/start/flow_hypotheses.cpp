// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/start/flow_hypotheses.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "core/base/bilinear.h"
#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_msf {

namespace {

constexpr int kLeastFlowSide = 16; // pixels: two patches

std::vector<FlowSample>
liftSegment (const CoarseFlow& flow,
             const RgbdFrame& current,
             const SegmentPixels& pixels,
             int segment,
             int level)
{
  const cv::Mat& target = current.levels()[0].inverse_depth;
  const int width = current.levels()[level].width();
  std::vector<FlowSample> samples;
  samples.reserve (pixels.size (segment));
  for (int i = pixels.begin[segment]; i < pixels.begin[segment + 1]; ++i) {
    const int x = std::min ((pixels.pixel[i] % width) << level, target.cols - 1);
    const int y = std::min ((pixels.pixel[i] / width) << level, target.rows - 1);
    const cv::Vec2f f = flow.at (x, y);
    const float u = static_cast<float> (x) + f[0];
    const float v = static_cast<float> (y) + f[1];
    if (!(u >= 0.0f && v >= 0.0f && u <= static_cast<float> (target.cols - 1) &&
          v <= static_cast<float> (target.rows - 1)))
      continue;
    const float w = target.at<float> (cvRound (v), cvRound (u));
    samples.push_back ({pixels.x[i], pixels.y[i], pixels.z[i], u, v, w});
  }
  return samples;
}

SampleTable
lift (const CoarseFlow& flow,
      const RgbdFrame& current,
      const SegmentPixels& pixels,
      const std::vector<char>& wanted,
      int level,
      int threads)
{
  std::vector<std::vector<FlowSample>> of_segment (pixels.segments());
  parallelFor (threads, pixels.segments(), 8, [&] (int k) {
    if (wanted[k])
      of_segment[k] = liftSegment (flow, current, pixels, k, level);
  });
  SampleTable table;
  table.begin.push_back (0);
  table.samples.reserve (pixels.pixel.size());
  for (const std::vector<FlowSample>& samples : of_segment) {
    table.samples.insert (table.samples.end(), samples.begin(), samples.end());
    table.begin.push_back (static_cast<int> (table.samples.size()));
  }
  return table;
}

/** Every segment's vote: a few of its samples. */
std::vector<FlowSample>
drawVoters (const SampleTable& table, int each)
{
  std::vector<FlowSample> voters;
  for (std::size_t k = 0; k + 1 < table.begin.size(); ++k) {
    const int n = table.begin[k + 1] - table.begin[k];
    const int take = std::min (n, each);
    for (int i = 0; i < take; ++i)
      voters.push_back (
          table.samples[table.begin[k] + static_cast<int> ((i + 0.5) * n / take)]);
  }
  return voters;
}

RigidPose
bestSupported (const std::vector<FlowSample>& voters,
               const std::vector<RigidPose>& candidates,
               const RigidFitOptions& options,
               double limit,
               int threads)
{
  std::vector<double> errors (candidates.size());
  const int n = static_cast<int> (candidates.size());
  parallelFor (threads, n, 8, [&] (int c) {
    errors[c] = meanTruncatedError (
        voters.data(), static_cast<int> (voters.size()), candidates[c], options, limit);
  });
  const auto best = std::min_element (errors.begin(), errors.end());
  return candidates[best - errors.begin()];
}

void
dropExplained (const RigidPose& pose,
               const RigidFitOptions& options,
               double limit,
               std::vector<FlowSample>& voters)
{
  const int count = static_cast<int> (voters.size());
  const std::vector<float> errors = sampleErrors (voters.data(), count, pose, options);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < voters.size(); ++i)
    if (!(errors[i] < limit))
      voters[kept++] = voters[i];
  voters.resize (kept);
}

/** Motions shared by many voters: the best supported one, refined; then the best of
 * those that it leaves unexplained, and so on. */
std::vector<RigidPose>
findBodies (const SampleTable& table,
            const std::vector<RigidPose>& candidates,
            const RigidFitOptions& options,
            const FlowTuning& tuning,
            int threads)
{
  std::vector<FlowSample> voters = drawVoters (table, tuning.voters);
  const std::size_t all = voters.size();
  std::vector<RigidPose> bodies;
  while (static_cast<int> (bodies.size()) < tuning.max_bodies && !candidates.empty() &&
         voters.size() > tuning.smallest_body * all) {
    RigidPose pose =
        bestSupported (voters, candidates, options, tuning.vote_limit, threads);
    pose =
        fitRigidMotion (voters.data(), static_cast<int> (voters.size()), pose, options);
    const std::size_t before = voters.size();
    dropExplained (pose, options, tuning.explained * tuning.vote_limit, voters);
    if (before - voters.size() < tuning.smallest_body * all)
      break;
    bodies.push_back (pose);
  }
  return bodies;
}

/** Flow between 8-bit images at half their resolution, of images of some width on
 * enlarged from that at a quarter: the segments' fits need no more. Where a side is
 * shorter than two of its patches, OpenCV chooses the pyramid by the width alone and
 * reads outside the image: the border is repeated up to there. */
cv::Mat
matchHalves (const cv::Mat& first,
             const cv::Mat& second,
             int quarter_width,
             int quarter_height)
{
  const cv::Size half (std::max (1, first.cols / 2), std::max (1, first.rows / 2));
  const int right = std::max (0, kLeastFlowSide - half.width);
  const int bottom = std::max (0, kLeastFlowSide - half.height);
  cv::Mat from;
  cv::Mat to;
  for (const auto& [image, small] : {std::pair{&first, &from}, {&second, &to}}) {
    cv::resize (*image, *small, half, 0, 0, cv::INTER_AREA);
    if (right > 0 || bottom > 0)
      cv::copyMakeBorder (*small, *small, 0, bottom, 0, right, cv::BORDER_REPLICATE);
  }
  cv::Mat flow;
  const auto dis = cv::DISOpticalFlow::create (cv::DISOpticalFlow::PRESET_MEDIUM);
  const bool large = first.cols >= quarter_width && first.rows >= quarter_height;
  dis->setFinestScale (large ? 1 : 0);
  dis->calc (from, to, flow);
  return flow (cv::Rect ({0, 0}, half));
}

} // namespace

/** Bilinear, flat beyond the outermost pixels' centres. */
cv::Vec2f
CoarseFlow::at (int x, int y) const
{
  const auto scale = static_cast<float> (1 << level);
  const auto place = [scale] (int full, int size, int& low, int& high) {
    const float at = std::clamp ((static_cast<float> (full) + 0.5f) / scale - 0.5f,
                                 0.0f,
                                 static_cast<float> (size - 1));
    low = static_cast<int> (at);
    high = std::min (low + 1, size - 1);
    return at - static_cast<float> (low);
  };
  int x0, x1, y0, y1;
  const float a = place (x, flow.cols, x0, x1);
  const float b = place (y, flow.rows, y0, y1);
  const cv::Vec2f* top = flow.ptr<cv::Vec2f> (y0);
  const cv::Vec2f* low = flow.ptr<cv::Vec2f> (y1);
  return scale * bilinear (a, b, top[x0], top[x1], low[x0], low[x1]);
}

cv::Mat
CoarseFlow::ofSize (const cv::Size& frames) const
{
  cv::Mat result;
  if (!flow.empty())
    inThisThread ([&] { cv::resize (flow * (1 << level), result, frames); });
  return result;
}

CoarseFlow
estimateOpticalFlow (const RgbdFrame& reference,
                     const RgbdFrame& current,
                     const FlowTuning& tuning,
                     int threads)
{
  CoarseFlow result{{}, 1};
  withThreads (threads, [&] {
    result.flow = matchHalves (
        reference.gray(), current.gray(), tuning.quarter_width, tuning.quarter_height);
  });
  return result;
}

CoarseFlow
estimateDepthFlow (const RgbdFrame& reference,
                   const RgbdFrame& current,
                   const FlowTuning& tuning)
{
  const int level = std::min<int> ({1,
                                    static_cast<int> (reference.levels().size()) - 1,
                                    static_cast<int> (current.levels().size()) - 1});
  const cv::Mat& first = reference.levels()[level].inverse_depth;
  const cv::Mat& second = current.levels()[level].inverse_depth;
  double nearest = 0.0;
  cv::minMaxLoc (first, nullptr, &nearest);
  const double scale = 255.0 / std::max (nearest, 1e-6);
  cv::Mat gray_first;
  cv::Mat gray_second;
  first.convertTo (gray_first, CV_8U, scale);
  second.convertTo (gray_second, CV_8U, scale);
  CoarseFlow result{{}, level + 1};
  inThisThread ([&] {
    result.flow = matchHalves (
        gray_first, gray_second, tuning.quarter_depth_width, tuning.quarter_height);
  });
  return result;
}

namespace {

/** Intensities that the flow matches, at the level of the samples. */
void
matchIntensities (const CoarseFlow& flow,
                  const RgbdFrame& current,
                  const SegmentPixels& pixels,
                  int level,
                  MatchedIntensities& matches)
{
  const cv::Mat& image = current.levels()[level].intensity;
  if (image.empty())
    return;
  const float scale = 1.0f / static_cast<float> (1 << level);
  for (std::size_t i = 0; i < pixels.pixel.size(); ++i) {
    const int x = pixels.pixel[i] % image.cols;
    const int y = pixels.pixel[i] / image.cols;
    const cv::Vec2f f = flow.at (x << level, y << level);
    const int u = cvRound (static_cast<float> (x) + f[0] * scale);
    const int v = cvRound (static_cast<float> (y) + f[1] * scale);
    if (u < 0 || v < 0 || u >= image.cols || v >= image.rows)
      continue;
    const cv::Point2f at = placeInImage (x, y, image.size());
    matches.reference.push_back (pixels.intensity[i]);
    matches.current.push_back (image.at<float> (v, u));
    matches.x.push_back (at.x);
    matches.y.push_back (at.y);
  }
}

} // namespace

FlowHypotheses
hypothesesFromFlow (const CoarseFlow& flow,
                    const RgbdFrame& current,
                    const SegmentPixels& pixels,
                    const std::vector<char>& wanted,
                    int level,
                    const NoiseModel& noise,
                    const RigidPose& start,
                    const StartTuning& tuning,
                    int threads)
{
  FlowHypotheses result;
  result.samples = lift (flow, current, pixels, wanted, level, threads);
  const SampleTable& table = result.samples;
  const RigidFitOptions options{current.camera(),
                                tuning.flow.noise * noise.inverse_depth,
                                tuning.flow.noise * noise.relative_depth,
                                tuning.fit};
  matchIntensities (flow, current, pixels, level, result.matches);
  const int segments = pixels.segments();
  result.of_segment.assign (segments, start);
  result.fitted.assign (segments, 0);
  parallelFor (threads, segments, 8, [&] (int k) {
    const int n = table.begin[k + 1] - table.begin[k];
    if (n < tuning.flow.min_samples)
      return;
    result.of_segment[k] =
        fitRigidMotion (table.samples.data() + table.begin[k], n, start, options);
    result.fitted[k] = 1;
  });
  std::vector<RigidPose> candidates;
  for (int k = 0; k < segments; k += 2)
    if (result.fitted[k])
      candidates.push_back (result.of_segment[k]);
  result.bodies = findBodies (table, candidates, options, tuning.flow, threads);
  return result;
}

} // namespace pcl_msf
