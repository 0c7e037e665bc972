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

cv::Mat
fuseInverseDepth (const FrameLevel& reference,
                  const cv::Mat& labels,
                  const std::vector<DepthSource>& sources,
                  const NoiseModel& noise,
                  const FusionTuning& tuning,
                  int threads)
{
  std::vector<std::vector<Turn>> turns;
  for (const DepthSource& source : sources)
    turns.push_back (unpack (source.motion.poses));
  const auto sigma = static_cast<float> (noise.inverse_depth);
  cv::Mat result = reference.inverse_depth.clone();
  const PinholeCamera& camera = reference.camera;
  parallelFor (threads, result.rows, 8, [&] (int y) {
    for (int x = 0; x < result.cols; ++x) {
      float& w = result.at<float> (y, x);
      const int k = labels.at<int> (y, x);
      if (k < 0 || w <= 0.0f || sigma <= 0.0f)
        continue;
      const Eigen::Vector3f ray (static_cast<float> ((x - camera.cx) / camera.fx),
                                 static_cast<float> ((y - camera.cy) / camera.fy),
                                 1.0f);
      const float model = tuning.model_share * w;
      const float trust = sigma * sigma / (sigma * sigma + model * model);
      float weights = 1.0f;
      float sum = 0.0f;
      for (std::size_t i = 0; i < sources.size(); ++i) {
        const Turn& turn = turns[i][sources[i].motion.body_of[k]];
        const float change = correction (
            *sources[i].level, turn, ray, w, tuning.sigmas * std::hypot (sigma, sigma));
        if (!std::isfinite (change))
          continue;
        weights += trust;
        sum += trust * change;
      }
      w = std::max (w + sum / weights, 0.5f * w);
    }
  });
  return result;
}

} // namespace pcl_msf
