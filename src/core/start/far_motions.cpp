// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/start/far_motions.h"

#include <opencv2/features2d.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_msf {

namespace {

struct Features {
  std::vector<cv::KeyPoint> places;
  cv::Mat descriptors;
};

Features
detect (const cv::Mat& gray, int most)
{
  Features features;
  cv::SIFT::create (most)->detectAndCompute (
      gray, cv::noArray(), features.places, features.descriptors);
  return features;
}

/** Per feature, its clear match in the other frame, or -1. */
std::vector<int>
distinctMatches (const cv::Mat& from, const cv::Mat& to, float distinct)
{
  std::vector<int> best (from.rows, -1);
  std::vector<std::vector<cv::DMatch>> found;
  cv::BFMatcher (cv::NORM_L2).knnMatch (from, to, found, 2);
  for (const auto& m : found)
    if (m.size() == 2 && m[0].distance < distinct * m[1].distance)
      best[m[0].queryIdx] = m[0].trainIdx;
  return best;
}

float
depthAt (const cv::Mat& inverse_depth, cv::Point2f at)
{
  const int x = std::clamp (cvRound (at.x), 0, inverse_depth.cols - 1);
  const int y = std::clamp (cvRound (at.y), 0, inverse_depth.rows - 1);
  return inverse_depth.at<float> (y, x);
}

float
squaredDistance (const FlowSample& a, const FlowSample& b)
{
  const float dx = a.x - b.x;
  const float dy = a.y - b.y;
  const float dz = a.z - b.z;
  return dx * dx + dy * dy + dz * dz;
}

/** A match and those nearest to it. */
std::vector<FlowSample>
group (const std::vector<FlowSample>& matches, int center, int size)
{
  std::vector<int> order (matches.size());
  std::iota (order.begin(), order.end(), 0);
  std::partial_sort (
      order.begin(), order.begin() + size, order.end(), [&] (int a, int b) {
        const float da = squaredDistance (matches[a], matches[center]);
        const float db = squaredDistance (matches[b], matches[center]);
        return da < db || (da == db && a < b);
      });
  std::vector<FlowSample> result;
  for (int i = 0; i < size; ++i)
    result.push_back (matches[order[i]]);
  return result;
}

} // namespace

std::vector<FlowSample>
matchFeatures (const RgbdFrame& reference,
               const RgbdFrame& current,
               const FarMotionTuning& tuning,
               int threads)
{
  Features first;
  Features second;
  std::vector<int> forth;
  std::vector<int> back;
  withThreads (threads, [&] {
    first = detect (reference.gray(), tuning.features);
    second = detect (current.gray(), tuning.features);
    if (first.descriptors.rows < 2 || second.descriptors.rows < 2)
      return;
    forth = distinctMatches (first.descriptors, second.descriptors, tuning.distinct);
    back = distinctMatches (second.descriptors, first.descriptors, tuning.distinct);
  });
  const PinholeCamera& k = reference.camera();
  std::vector<FlowSample> matches;
  for (std::size_t i = 0; i < forth.size(); ++i) {
    if (forth[i] < 0 || back[forth[i]] != static_cast<int> (i))
      continue;
    const cv::Point2f p = first.places[i].pt;
    const cv::Point2f q = second.places[forth[i]].pt;
    const float w = depthAt (reference.levels()[0].inverse_depth, p);
    if (!(w > 0.0f))
      continue;
    const float z = 1.0f / w;
    matches.push_back ({static_cast<float> ((p.x - k.cx) / k.fx) * z,
                        static_cast<float> ((p.y - k.cy) / k.fy) * z,
                        z,
                        q.x,
                        q.y,
                        depthAt (current.levels()[0].inverse_depth, q)});
  }
  return matches;
}

std::vector<RigidPose>
motionsOfMatches (const std::vector<FlowSample>& matches,
                  const RigidPose& start,
                  const RigidFitOptions& options,
                  const FarMotionTuning& tuning,
                  int threads)
{
  std::vector<RigidPose> motions;
  const int n = static_cast<int> (matches.size());
  if (n < tuning.min_matches)
    return motions;
  const int groups = std::min (n, tuning.most_groups);
  const int size = std::min (n, tuning.group);
  std::vector<RigidPose> candidates (groups);
  parallelFor (threads, groups, 8, [&] (int g) {
    const auto own =
        group (matches, static_cast<int> (static_cast<long> (g) * n / groups), size);
    candidates[g] = fitRigidMotion (own.data(), size, start, options);
  });
  std::vector<FlowSample> left = matches;
  while (static_cast<int> (motions.size()) < tuning.most_motions &&
         static_cast<int> (left.size()) >= tuning.min_matches) {
    std::vector<double> errors (groups);
    const int count = static_cast<int> (left.size());
    parallelFor (threads, groups, 8, [&] (int g) {
      errors[g] =
          meanTruncatedError (left.data(), count, candidates[g], options, tuning.agree);
    });
    const auto best = std::min_element (errors.begin(), errors.end()) - errors.begin();
    const auto agrees = [&] (const FlowSample& s, const RigidPose& pose) {
      return meanTruncatedError (&s, 1, pose, options, tuning.agree) <
             tuning.explained * tuning.agree;
    };
    std::vector<FlowSample> support;
    for (const FlowSample& s : left)
      if (agrees (s, candidates[best]))
        support.push_back (s);
    if (static_cast<int> (support.size()) < tuning.min_matches)
      break;
    const RigidPose pose = fitRigidMotion (
        support.data(), static_cast<int> (support.size()), candidates[best], options);
    motions.push_back (pose);
    const std::size_t before = left.size();
    left.erase (std::remove_if (left.begin(),
                                left.end(),
                                [&] (const FlowSample& s) { return agrees (s, pose); }),
                left.end());
    if (left.size() == before)
      break;
  }
  return motions;
}

FarMotions
findFarMotions (const RgbdFrame& reference,
                const RgbdFrame& current,
                const CoarseFlow& flow,
                const RigidPose& start,
                const RigidFitOptions& options,
                const FarMotionTuning& tuning,
                int threads)
{
  const std::vector<FlowSample> matches =
      matchFeatures (reference, current, tuning, threads);
  const PinholeCamera& k = reference.camera();
  std::vector<FlowSample> missed;
  for (const FlowSample& m : matches) {
    const double x = k.fx * m.x / m.z + k.cx;
    const double y = k.fy * m.y / m.z + k.cy;
    const cv::Vec2f f = flow.at (std::clamp (cvRound (x), 0, reference.width() - 1),
                                 std::clamp (cvRound (y), 0, reference.height() - 1));
    if (std::hypot (x + f[0] - m.u, y + f[1] - m.v) > tuning.agree)
      missed.push_back (m);
  }
  FarMotions far;
  far.motions = motionsOfMatches (missed, start, options, tuning, threads);
  far.instead_of_flow = !far.motions.empty() &&
                        static_cast<int> (missed.size()) >= tuning.enough &&
                        2 * missed.size() > matches.size();
  return far;
}

} // namespace pcl_msf
