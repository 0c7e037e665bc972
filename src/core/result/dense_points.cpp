// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/dense_points.h"

#include "core/base/parallel_for.h"
#include "core/result/unknown_image.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** One motion that takes part in moving a segment's points. */
struct BlendedMotion {
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;
  float u, v;          ///< centre in the reference image, pixels
  float inverse_reach; ///< 1 / (2 sigma^2), 1 / pixels^2
  float strength;      ///< mixing of the connection
};

BlendedMotion
blendedMotionOf (const SceneFlow& scene,
                 int segment,
                 double strength,
                 double reach_share)
{
  const SegmentMotion& motion = scene.segments[segment];
  const Eigen::Vector2d center = scene.camera.project (motion.centroid);
  const double reach = reach_share * std::sqrt (std::max (16, motion.points));
  return {motion.current_from_reference.rotation().cast<float>(),
          motion.current_from_reference.translation().cast<float>(),
          static_cast<float> (center.x()),
          static_cast<float> (center.y()),
          static_cast<float> (0.5 / (reach * reach)),
          static_cast<float> (strength)};
}

/** The motions that move each segment's points; its own first. */
std::vector<std::vector<BlendedMotion>>
findBlendedMotions (const SceneFlow& scene, bool blend, const BlendTuning& tuning)
{
  std::vector<std::vector<BlendedMotion>> motions (scene.segments.size());
  std::vector<char> soft (scene.segments.size(), 0);
  for (std::size_t k = 0; k < motions.size(); ++k)
    if (scene.segments[k].points > 0)
      motions[k].push_back (
          blendedMotionOf (scene, static_cast<int> (k), 1.0, tuning.reach));
  if (!blend)
    return motions;
  const auto usable = [&] (int k) {
    return scene.segments[k].status == MotionStatus::Determined;
  };
  for (const SegmentPair& pair : scene.pairs) {
    const double strength = pair.mixing;
    if (strength < tuning.least_strength)
      continue;
    const bool differ = scene.segments[pair.first].current_from_reference.parameters !=
                        scene.segments[pair.second].current_from_reference.parameters;
    if (usable (pair.second)) {
      motions[pair.first].push_back (
          blendedMotionOf (scene, pair.second, strength, tuning.reach));
      soft[pair.first] |= differ;
    }
    if (usable (pair.first)) {
      motions[pair.second].push_back (
          blendedMotionOf (scene, pair.first, strength, tuning.reach));
      soft[pair.second] |= differ;
    }
  }
  for (std::size_t k = 0; k < motions.size(); ++k)
    if (!soft[k])
      motions[k].resize (std::min<std::size_t> (motions[k].size(), 1));
  return motions;
}

Eigen::Vector3f
move (const std::vector<BlendedMotion>& motions,
      const Eigen::Vector3f& p,
      float x,
      float y)
{
  if (motions.size() == 1)
    return motions[0].rotation * p + motions[0].translation;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weights = 0.0f;
  for (const BlendedMotion& k : motions) {
    const float dx = x - k.u;
    const float dy = y - k.v;
    const float weight =
        k.strength * std::exp (-(dx * dx + dy * dy) * k.inverse_reach) + 1e-12f;
    sum += weight * (k.rotation * p + k.translation);
    weights += weight;
  }
  return sum / weights;
}

/** Writes one point of a segment whose motion is known. */
void
writeMotion (const Eigen::Vector3f& point,
             const Eigen::Vector3f& moved,
             const PinholeCamera& camera,
             int x,
             int y,
             SceneFlow& result)
{
  const Eigen::Vector3f d = moved - point;
  result.displacement.ptr<cv::Vec3f> (y)[x] = {d.x(), d.y(), d.z()};
  if (moved.z() <= 1e-3f)
    return;
  const double w = 1.0 / moved.z();
  result.flow.ptr<cv::Vec2f> (y)[x] = {
      static_cast<float> (camera.fx * moved.x() * w + camera.cx - x),
      static_cast<float> (camera.fy * moved.y() * w + camera.cy - y)};
}

} // namespace

void
fillPoints (const SegmentPixels& p,
            const PinholeCamera& camera,
            bool blend,
            const BlendTuning& tuning,
            int threads,
            SceneFlow& result)
{
  const cv::Size size = result.labels.size();
  result.points = unknownImage (size, 3, threads);
  result.displacement = unknownImage (size, 3, threads);
  result.flow = unknownImage (size, 2, threads);
  const auto motions = findBlendedMotions (result, blend, tuning);
  parallelFor (threads, p.segments(), 8, [&] (int k) {
    const bool known = result.segments[k].status != MotionStatus::Undetermined;
    for (int i = p.begin[k]; i < p.begin[k + 1]; ++i) {
      const int x = p.pixel[i] % size.width;
      const int y = p.pixel[i] / size.width;
      const Eigen::Vector3f point (p.x[i], p.y[i], p.z[i]);
      result.points.ptr<cv::Vec3f> (y)[x] = {p.x[i], p.y[i], p.z[i]};
      if (known)
        writeMotion (
            point,
            move (motions[k], point, static_cast<float> (x), static_cast<float> (y)),
            camera,
            x,
            y,
            result);
    }
  });
}

} // namespace pcl_msf
