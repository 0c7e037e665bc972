// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/window/depth_fusion.h"

#include "core/base/bilinear.h"
#include "core/base/parallel_for.h"

#include <cmath>

namespace pcl_msf {

namespace {

struct Turn {
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;
};

std::vector<Turn>
unpack (const std::vector<RigidPose>& poses)
{
  std::vector<Turn> turns;
  for (const RigidPose& pose : poses)
    turns.push_back ({pose.rotation().cast<float>(), pose.translation().cast<float>()});
  return turns;
}

/** Bilinear inverse depth; 0 unless all four pixels lie on one surface. */
float
measuredAt (const cv::Mat& inverse_depth, float u, float v, float gate)
{
  const int x = static_cast<int> (std::floor (u));
  const int y = static_cast<int> (std::floor (v));
  if (x < 0 || y < 0 || x + 1 >= inverse_depth.cols || y + 1 >= inverse_depth.rows)
    return 0.0f;
  const float* upper = inverse_depth.ptr<float> (y) + x;
  const float* lower = inverse_depth.ptr<float> (y + 1) + x;
  const float w[4] = {upper[0], upper[1], lower[0], lower[1]};
  float least = w[0];
  float most = w[0];
  for (const float value : w) {
    least = std::min (least, value);
    most = std::max (most, value);
  }
  if (least <= 0.0f || most - least > 2.0f * gate)
    return 0.0f;
  const float a = u - static_cast<float> (x);
  const float b = v - static_cast<float> (y);
  return bilinear (a, b, w[0], w[1], w[2], w[3]);
}

/** What a source changes about a point's inverse depth; NaN when it does not see it.
 */
float
correction (const FrameLevel& level,
            const Turn& turn,
            const Eigen::Vector3f& ray,
            float w,
            float gate)
{
  const float unseen = std::nanf ("");
  const Eigen::Vector3f turned = turn.rotation * ray;
  const Eigen::Vector3f q = turned + w * turn.translation; // the point over its depth
  if (!(q.z() > 0.0f && turned.z() > 0.0f))
    return unseen;
  const PinholeCamera& c = level.camera;
  const float u = static_cast<float> (c.fx) * q.x() / q.z() + static_cast<float> (c.cx);
  const float v = static_cast<float> (c.fy) * q.y() / q.z() + static_cast<float> (c.cy);
  const float measured = measuredAt (level.inverse_depth, u, v, gate);
  const float difference = measured - w / q.z();
  if (measured <= 0.0f || std::abs (difference) > gate)
    return unseen;
  // d (w / q_z) / d w = turned_z / q_z^2
  return difference * q.z() * q.z() / turned.z();
}

} // namespace

DepthFusion::DepthFusion (const FrameLevel& reference, const cv::Mat& labels)
: camera_ (reference.camera), inverse_depth_ (reference.inverse_depth), labels_ (labels)
{}

void
DepthFusion::add (const DepthSource& source,
                  const NoiseModel& noise,
                  const FusionTuning& tuning,
                  int threads)
{
  if (sums_.empty())
    sums_ = cv::Mat (inverse_depth_.size(), CV_32FC2, cv::Scalar (1.0, 0.0));
  const std::vector<Turn> turns = unpack (source.motion.poses);
  const auto sigma = static_cast<float> (noise.inverse_depth);
  if (sigma <= 0.0f)
    return;
  const float gate = tuning.sigmas * std::hypot (sigma, sigma);
  parallelFor (threads, sums_.rows, 8, [&] (int y) {
    const int* labels = labels_.ptr<int> (y);
    const float* reference = inverse_depth_.ptr<float> (y);
    cv::Vec2f* sums = sums_.ptr<cv::Vec2f> (y);
    const auto ray_y = static_cast<float> ((y - camera_.cy) / camera_.fy);
    for (int x = 0; x < sums_.cols; ++x) {
      const float w = reference[x];
      if (labels[x] < 0 || w <= 0.0f)
        continue;
      const Eigen::Vector3f ray (
          static_cast<float> ((x - camera_.cx) / camera_.fx), ray_y, 1.0f);
      const float change = correction (
          *source.level, turns[source.motion.body_of[labels[x]]], ray, w, gate);
      if (!std::isfinite (change))
        continue;
      const float model = tuning.model_share * w;
      const float weight = sigma * sigma / (sigma * sigma + model * model);
      sums[x][0] += weight;
      sums[x][1] += weight * change;
    }
  });
}

cv::Mat
DepthFusion::average() const
{
  if (sums_.empty())
    return {};
  cv::Mat result = inverse_depth_.clone();
  for (int y = 0; y < result.rows; ++y) {
    float* w = result.ptr<float> (y);
    const cv::Vec2f* sums = sums_.ptr<cv::Vec2f> (y);
    for (int x = 0; x < result.cols; ++x)
      w[x] = std::max (w[x] + sums[x][1] / sums[x][0], 0.5f * w[x]);
  }
  return result;
}

} // namespace pcl_msf
