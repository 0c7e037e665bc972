// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/part_view.h"

#include "core/points/residual_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_msf {

PartView::PartView (const PointFrame& frame, const PointTuning& tuning, int threads)
: source_ (frame.clouds.source.surface)
, prior_ (frame.prior)
, segments_ (frame.solve->segments())
, target_ (frame.solve->fineTarget())
, spacing_ (frame.clouds.target.surface.median_spacing)
, tuning_ (tuning.parts)
, brightness_ (tuning.brightness)
, threads_ (threads)
, poses_ (frame.solve->poses())
, all_{source_.points,
       source_.normals,
       segments_.members,
       frame.clouds.source.texture.value}
{
  const MovedPoints moved = movePoints (all_, poses_, threads_);
  pulls_ =
      target_.pulls (moved, fineRules (tuning_.reach * spacing_, tuning_), threads_);
  variance_ = std::pow (std::max (deviationOf (moved, pulls_, tuning_.least_weight),
                                  tuning_.floor * spacing_),
                        2);
  if (!all_.brightness.empty())
    pulls_ = target_.pulls (moved, rules (tuning_.reach * spacing_), threads_);
}

MergeView
PartView::mergeView() const
{
  return {momentsOf (segments_.label, pulls_, poses_.size()), poses_, variance_};
}

BorderView
PartView::borderView()
{
  return {target_, poses_, all_.brightness, rules (tuning_.reach * spacing_), spacing_};
}

/** By shape and brightness, each as precise as it is. */
MatchRules
PartView::rules (double distance) const
{
  MatchRules rules = fineRules (distance, tuning_);
  rules.brightness = std::sqrt (variance_);
  rules.brightness_weight = brightness_.part_weight;
  rules.outlying = brightness_.outlying;
  return rules;
}

/** Of matches and known pairs, per label of the points. A pair of weight 1 is known to
 * about a spacing. */
std::vector<RigidMoments>
PartView::momentsOf (const std::vector<int>& label,
                     std::vector<PointPull> pulls,
                     std::size_t parts) const
{
  prior_.weigh ({}, pulls);
  std::vector<RigidMoments> moments (parts);
  for (int i = 0; i < source_.size(); ++i)
    moments[label[i]].add (source_.points[i].cast<double>(), pulls[i], 1.0);
  const double unit = variance_ / (spacing_ * spacing_);
  for (const KnownPoint& known : prior_.points)
    moments[label[known.place]].add (
        known.point.cast<double>(), known.pull (unit), 1.0);
  return moments;
}

void
PartView::followParts (const PartLabels& labels)
{
  for (int k = 0; k < segments_.size(); ++k)
    if (labels.rigid[labels.part_of[k]])
      poses_[k] = part_poses_[labels.part_of[k]];
}

void
PartView::polish (const PartLabels& labels, const BodySeams& seams)
{
  MatchRules own = rules (spacing_);
  own.plane = tuning_.outlying * std::sqrt (variance_);
  moments_ = momentsOf (
      labels.part, target_.pulls (moved(), own, threads_), part_poses_.size());
  holdSeams (seams, part_poses_, tuning_, moments_);
  for (std::size_t p = 0; p < part_poses_.size(); ++p)
    if (labels.free[p])
      part_poses_[p] = moments_[p].solve (part_poses_[p]);
  followParts (labels);
}

/** Mean distance of every part's points from the target. */
std::vector<double>
PartView::partDistances (const PartLabels& labels)
{
  std::vector<double> sums (part_poses_.size(), 0.0);
  std::vector<int> counts (part_poses_.size(), 0);
  const std::vector<float> distances = target_.distances (
      moved(), rules (tuning_.reach * spacing_), tuning_.limit * spacing_, threads_);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    sums[labels.part[i]] += distances[i];
    ++counts[labels.part[i]];
  }
  for (std::size_t p = 0; p < sums.size(); ++p)
    sums[p] /= std::max (1, counts[p]);
  return sums;
}

void
PartView::polishWithCare (const PartLabels& labels, const BodySeams& seams)
{
  if (least_.empty())
    least_ = partDistances (labels);
  const std::vector<RigidPose> before = part_poses_;
  polish (labels, seams);
  const std::vector<double> now = partDistances (labels);
  for (std::size_t p = 0; p < now.size(); ++p) {
    if (now[p] > (1.0 + tuning_.worse_share) * least_[p])
      part_poses_[p] = before[p];
    least_[p] = std::min (least_[p], now[p]);
  }
  followParts (labels);
}

double
PartView::pairCost (const KnownPoint& known, int part) const
{
  const Eigen::Vector3d moved = part_poses_[part] * known.point.cast<double>();
  return 0.5 * known.weight * (moved - known.target).squaredNorm() /
         (spacing_ * spacing_);
}

double
PartView::pairLoss (const PartLabels& labels, int part, int other) const
{
  double cost = 0.0;
  for (const KnownPoint& known : prior_.points)
    if (labels.part[known.place] == part)
      cost += pairCost (known, other) - pairCost (known, part);
  return cost;
}

double
PartView::distanceOf (const std::vector<int>& points,
                      const std::vector<Membership>& members)
{
  PointSamples some;
  for (const int i : points) {
    some.points.push_back (source_.points[i]);
    some.normals.push_back (source_.normals[i]);
    if (!all_.brightness.empty())
      some.brightness.push_back (all_.brightness[i]);
    some.members.push_back (members.empty() ? all_.members[i] : members);
  }
  double sum = 0.0;
  for (const float d : target_.distances (movePoints (some, poses_, threads_),
                                          rules (tuning_.reach * spacing_),
                                          tuning_.limit * spacing_,
                                          threads_))
    sum += d;
  return sum / std::max<std::size_t> (1, points.size());
}

RigidPose
PartView::poseOf (int part, Matrix6& information) const
{
  moments_[part].solve (part_poses_[part], &information);
  information /= variance_;
  return part_poses_[part];
}

} // namespace pcl_msf
