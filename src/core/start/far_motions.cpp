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

constexpr int kFeatures = 1500;   // strongest ones of a frame
constexpr float kDistinct = 0.8f; // distance of the best match by that of the second
constexpr int kGroup = 6;         // matches of a fit: a match and those nearest to it
constexpr int kMostGroups = 400;
constexpr int kLeastSupport = 15;   // matches of a motion
constexpr std::size_t kEnough = 60; // matches that may contradict the flow
constexpr int kMostMotions = 8;
constexpr double kAgree = 3.0; // pixels

struct Features {
  std::vector<cv::KeyPoint> places;
  cv::Mat descriptors;
};

Features
detect (const cv::Mat& gray)
{
  Features features;
  cv::SIFT::create (kFeatures)->detectAndCompute (
      gray, cv::noArray(), features.places, features.descriptors);
  return features;
}

/** Per feature, its clear match in the other frame, or -1. */
std::vector<int>
distinctMatches (const cv::Mat& from, const cv::Mat& to)
{
  std::vector<int> best (from.rows, -1);
  std::vector<std::vector<cv::DMatch>> found;
  cv::BFMatcher (cv::NORM_L2).knnMatch (from, to, found, 2);
  for (const auto& m : found)
    if (m.size() == 2 && m[0].distance < kDistinct * m[1].distance)
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
group (const std::vector<FlowSample>& matches, int center)
{
  std::vector<int> order (matches.size());
  std::iota (order.begin(), order.end(), 0);
  std::partial_sort (
      order.begin(), order.begin() + kGroup, order.end(), [&] (int a, int b) {
        const float da = squaredDistance (matches[a], matches[center]);
        const float db = squaredDistance (matches[b], matches[center]);
        return da < db || (da == db && a < b);
      });
  std::vector<FlowSample> result;
  for (int i = 0; i < kGroup; ++i)
    result.push_back (matches[order[i]]);
  return result;
}

} // namespace

std::vector<FlowSample>
matchFeatures (const RgbdFrame& reference, const RgbdFrame& current, int threads)
{
  Features first;
  Features second;
  std::vector<int> forth;
  std::vector<int> back;
  withThreads (threads, [&] {
    first = detect (reference.gray());
    second = detect (current.gray());
    if (first.descriptors.rows < 2 || second.descriptors.rows < 2)
      return;
    forth = distinctMatches (first.descriptors, second.descriptors);
    back = distinctMatches (second.descriptors, first.descriptors);
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
                  int threads)
{
  std::vector<RigidPose> motions;
  const int n = static_cast<int> (matches.size());
  if (n < kLeastSupport)
    return motions;
  const int groups = std::min (n, kMostGroups);
  std::vector<RigidPose> candidates (groups);
  parallelFor (threads, groups, 8, [&] (int g) {
    const auto own =
        group (matches, static_cast<int> (static_cast<long> (g) * n / groups));
    candidates[g] = fitRigidMotion (own.data(), kGroup, start, options);
  });
  std::vector<FlowSample> left = matches;
  while (static_cast<int> (motions.size()) < kMostMotions &&
         static_cast<int> (left.size()) >= kLeastSupport) {
    std::vector<double> errors (groups);
    const int count = static_cast<int> (left.size());
    parallelFor (threads, groups, 8, [&] (int g) {
      errors[g] =
          meanTruncatedError (left.data(), count, candidates[g], options, kAgree);
    });
    const auto best = std::min_element (errors.begin(), errors.end()) - errors.begin();
    const auto agrees = [&] (const FlowSample& s, const RigidPose& pose) {
      return meanTruncatedError (&s, 1, pose, options, kAgree) < 0.7 * kAgree;
    };
    std::vector<FlowSample> support;
    for (const FlowSample& s : left)
      if (agrees (s, candidates[best]))
        support.push_back (s);
    if (static_cast<int> (support.size()) < kLeastSupport)
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
                int threads)
{
  const std::vector<FlowSample> matches = matchFeatures (reference, current, threads);
  const PinholeCamera& k = reference.camera();
  std::vector<FlowSample> missed;
  for (const FlowSample& m : matches) {
    const double x = k.fx * m.x / m.z + k.cx;
    const double y = k.fy * m.y / m.z + k.cy;
    const cv::Vec2f f = flow.at (std::clamp (cvRound (x), 0, reference.width() - 1),
                                 std::clamp (cvRound (y), 0, reference.height() - 1));
    if (std::hypot (x + f[0] - m.u, y + f[1] - m.v) > kAgree)
      missed.push_back (m);
  }
  FarMotions far;
  far.motions = motionsOfMatches (missed, start, options, threads);
  far.instead_of_flow = !far.motions.empty() && missed.size() >= kEnough &&
                        2 * missed.size() > matches.size();
  return far;
}

} // namespace pcl_msf
