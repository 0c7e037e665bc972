// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/start/flow_precision.h"

#include <Eigen/Eigenvalues>

#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/order_statistics.h"
#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr int kLevel = 2;             // the flow's finest, of large images
constexpr int kPatch = 8;             // pixels of that level: DIS's
constexpr double kSobel = 1.0 / 32.0; // of Scharr's filter
constexpr double kFlat = 1e-6; // 1 / pixels^2: without texture a place is not known

/** Sums of products of the derivatives over a patch around every pixel of a level. */
class StructureTensor {
public:
  StructureTensor() = default;
  explicit StructureTensor (const RgbdFrame& frame)
  : level_ (std::min (kLevel, static_cast<int> (frame.levels().size()) - 1))
  {
    const cv::Mat& image = frame.levels()[level_].intensity;
    cv::Mat x;
    cv::Mat y;
    cv::Scharr (image, x, CV_32F, 1, 0, kSobel);
    cv::Scharr (image, y, CV_32F, 0, 1, kSobel);
    const cv::Mat products[3] = {x.mul (x), x.mul (y), y.mul (y)};
    for (int i = 0; i < 3; ++i)
      cv::boxFilter (
          products[i], sums_[i], -1, {kPatch, kPatch}, cv::Point (-1, -1), false);
  }

  /** Per squared pixel of the frame itself. */
  Eigen::Matrix2d
  at (double u, double v) const
  {
    const int side = 1 << level_;
    const int x = std::clamp (cvRound (u / side), 0, sums_[0].cols - 1);
    const int y = std::clamp (cvRound (v / side), 0, sums_[0].rows - 1);
    Eigen::Matrix2d tensor;
    tensor << sums_[0].at<float> (y, x), sums_[1].at<float> (y, x),
        sums_[1].at<float> (y, x), sums_[2].at<float> (y, x);
    return tensor / (side * side);
  }

private:
  int level_{0};
  cv::Mat sums_[3];
};

Eigen::Vector2d
project (const PinholeCamera& k, const Eigen::Vector3d& p)
{
  return {k.fx * p.x() / p.z() + k.cx, k.fy * p.y() / p.z() + k.cy};
}

/** How far a rigid motion stays from its samples' flow, median in pixels. */
double
misfit (const std::vector<FlowMatch>& matches,
        int begin,
        int end,
        const RigidPose& pose,
        const PinholeCamera& camera)
{
  const Eigen::Matrix3d rotation = pose.rotation();
  std::vector<double> distances;
  for (int i = begin; i < end; ++i) {
    const FlowSample& s = matches[i].sample;
    const Eigen::Vector3d p =
        rotation * Eigen::Vector3d (s.x, s.y, s.z) + pose.translation();
    distances.push_back ((project (camera, p) - Eigen::Vector2d (s.u, s.v)).norm());
  }
  return median (distances);
}

void
whiten (const Eigen::Matrix2d& covariance, float* out)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect (covariance);
  const Eigen::Matrix2d root = solver.operatorInverseSqrt();
  out[0] = static_cast<float> (root (0, 0));
  out[1] = static_cast<float> (root (0, 1));
  out[2] = static_cast<float> (root (1, 1));
}

} // namespace

FlowEvidence
evidenceOfFlow (const FlowHypotheses& flow,
                const RgbdFrame& reference,
                const PinholeCamera& current,
                const NoiseModel& noise,
                const FlowEvidenceTuning& tuning,
                int threads)
{
  const int segments = static_cast<int> (flow.of_segment.size());
  const auto samples = [&] (int k) {
    return flow.samples.begin[k + 1] - flow.samples.begin[k];
  };
  std::vector<int> begin{0};
  for (int k = 0; k < segments; ++k)
    begin.push_back (begin.back() + std::min (samples (k), tuning.samples));
  std::vector<FlowMatch> matches (begin.back());
  StructureTensor texture;
  inThisThread ([&] { texture = StructureTensor (reference); });
  const double variance = noise.intensity * noise.intensity * noise.areas.brightness;
  parallelFor (threads, segments, 16, [&] (int k) {
    const int count = begin[k + 1] - begin[k];
    if (count == 0)
      return;
    for (int i = 0; i < count; ++i)
      matches[begin[k] + i].sample =
          flow.samples.samples[flow.samples.begin[k] +
                               static_cast<int> ((i + 0.5) * samples (k) / count)];
    const double rigid = std::max (
        tuning.sigma,
        tuning.spread *
            misfit (matches, begin[k], begin[k + 1], flow.of_segment[k], current));
    for (int i = begin[k]; i < begin[k + 1]; ++i) {
      const FlowSample& s = matches[i].sample;
      const Eigen::Vector2d at = project (reference.camera(), {s.x, s.y, s.z});
      const Eigen::Matrix2d known =
          texture.at (at.x(), at.y()) / variance + kFlat * Eigen::Matrix2d::Identity();
      whiten (rigid * rigid * Eigen::Matrix2d::Identity() + known.inverse(),
              matches[i].whitening);
    }
  });
  return {std::move (matches), std::move (begin), current, tuning.cap};
}

} // namespace pcl_msf
