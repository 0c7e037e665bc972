// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_brightness.h"

#include "core/base/order_statistics.h"

#include <cmath>

namespace pcl_msf {

namespace {

constexpr double kToDeviation = 1.4826; // of a median of absolute differences

constexpr double kCounts = 0.1; // least weight of a match that tells the noise

/** Weighted mean and variance. */
struct Spread {
  double sum{0.0};
  double first{0.0};
  double second{0.0};

  void
  add (double value, double weight)
  {
    sum += weight;
    first += weight * value;
    second += weight * value * value;
  }
  double
  mean () const
  {
    return first / sum;
  }
  double
  variance () const
  {
    return second / sum - mean() * mean();
  }
};

} // namespace

BrightnessComparison::BrightnessComparison (const MovedPoints& moved,
                                            const std::vector<PointPair>& matches,
                                            const Surface& surface,
                                            const SurfaceTexture& texture,
                                            double reach,
                                            double weight,
                                            double outlying)
: surface_ (&surface), texture_ (&texture)
{
  if (moved.brightness.empty() || !texture.varies() || !fitExposure (moved, matches))
    return;
  std::vector<double> differences;
  for (const PointPair& match : matches)
    if (match.source >= 0 && match.weight > kCounts &&
        knows (moved, match.source, match.target))
      differences.push_back (std::abs (difference (moved, match.source, match.target)));
  if (differences.empty())
    return;
  const double deviation = kToDeviation * median (differences);
  weight_ =
      weight * texture.trust * reach * reach / (reach * reach + deviation * deviation);
  scale_ = std::hypot (reach, outlying * deviation);
}

/** By the spreads of both, which wrong matches do not change as they do a line's slope.
 */
bool
BrightnessComparison::fitExposure (const MovedPoints& moved,
                                   const std::vector<PointPair>& matches)
{
  Spread source;
  Spread target;
  double product = 0.0;
  for (const PointPair& match : matches)
    if (match.source >= 0 && knows (moved, match.source, match.target)) {
      const Eigen::Vector3f shift =
          moved.points[match.source] - surface_->points[match.target];
      const double here =
          texture_->value[match.target] + texture_->gradient[match.target].dot (shift);
      source.add (moved.brightness[match.source], match.weight);
      target.add (here, match.weight);
      product += match.weight * here * moved.brightness[match.source];
    }
  if (!(source.sum > 0.0) || !(source.variance() > 0.0) || !(target.variance() > 0.0))
    return false;
  correlation_ = (product / source.sum - source.mean() * target.mean()) /
                 std::sqrt (source.variance() * target.variance());
  gain_ = std::sqrt (target.variance() / source.variance());
  offset_ = target.mean() - gain_ * source.mean();
  return std::isfinite (gain_);
}

bool
BrightnessComparison::knows (const MovedPoints& moved, int i, int j) const
{
  return std::isfinite (moved.brightness[i]) && std::isfinite (texture_->value[j]);
}

double
BrightnessComparison::difference (const MovedPoints& moved, int i, int j) const
{
  const Eigen::Vector3d shift = (moved.points[i] - surface_->points[j]).cast<double>();
  return slope (j).dot (shift) +
         (texture_->value[j] - gain_ * moved.brightness[i] - offset_) / texture_->slope;
}

} // namespace pcl_msf
