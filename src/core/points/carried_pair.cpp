// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/carried_pair.h"

#include "core/base/parallel_for.h"

namespace pcl_msf {

namespace {

/** The target's samples near the moved source, each with the segments of the nearest of
 * the source's. */
PointSamples
carrySamples (const PointFrame& frame, double near, int threads)
{
  const PointSamples& source = frame.solve->samples();
  const MovedPoints moved = movePoints (source, frame.solve->poses(), threads);
  const WorkingCloud& target = frame.clouds.target;
  FeatureTree tree;
  tree.take (moved.points, moved.normals, near);
  std::vector<int> nearest (target.samples.size(), -1);
  parallelFor (threads, static_cast<int> (nearest.size()), 128, [&] (int s) {
    const Eigen::Vector3f& point = target.surface.points[target.samples[s]];
    const Eigen::Vector3f& normal = target.surface.normals[target.samples[s]];
    const int j = tree.nearest (point, normal, -1);
    if (j >= 0 && (moved.points[j] - point).norm() < near &&
        moved.normals[j].dot (normal) > 0.0f)
      nearest[s] = j;
  });
  PointSamples samples;
  for (std::size_t s = 0; s < nearest.size(); ++s) {
    if (nearest[s] < 0)
      continue;
    const int i = target.samples[s];
    samples.points.push_back (target.surface.points[i]);
    samples.normals.push_back (target.surface.normals[i]);
    samples.members.push_back (source.members[nearest[s]]);
    if (!target.texture.value.empty())
      samples.brightness.push_back (target.texture.value[i]);
  }
  return samples;
}

/** The source's segments where they have moved to. */
SurfaceSegments
carrySegments (const PointFrame& frame)
{
  const std::vector<RigidPose>& poses = frame.solve->poses();
  const SurfaceSegments& source = frame.solve->segments();
  SurfaceSegments segments;
  segments.seeds = source.seeds;
  segments.links = source.links;
  segments.radius = source.radius;
  segments.fixed = source.fixed;
  for (int k = 0; k < source.size(); ++k)
    segments.centroids.emplace_back (poses[k] * source.centroids[k]);
  for (SegmentLink& link : segments.links)
    link.midpoint =
        0.5 * (poses[link.first] * link.midpoint + poses[link.second] * link.midpoint);
  return segments;
}

std::vector<RigidPose>
posesBetween (const PointFrame& from, const PointFrame& to)
{
  std::vector<RigidPose> poses;
  for (std::size_t k = 0; k < to.solve->poses().size(); ++k)
    poses.push_back (to.solve->poses()[k] * from.solve->poses()[k].inverse());
  return poses;
}

} // namespace

CarriedPair::CarriedPair (const PointFrame& from,
                          const PointFrame& to,
                          const PointEnergyWeights& weights,
                          double near,
                          int threads)
: threads_ (threads)
, samples_ (carrySamples (from, near, threads))
, segments_ (carrySegments (from))
, poses_ (posesBetween (from, to))
, target_ (to.clouds.target.surface, to.clouds.target.samples, to.clouds.target.texture)
, terms_ (samples_, none_, segments_, weights, threads, poses_)
{}

std::vector<PointPull>
CarriedPair::pulls (const MatchRules& rules)
{
  return target_.pulls (movePoints (samples_, poses_, threads_), rules, threads_);
}

} // namespace pcl_msf
