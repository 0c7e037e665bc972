// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_matching.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace pcl_msf {

namespace {

using Feature = std::array<float, 6>;

Feature
featureOf (const Eigen::Vector3f& point, const Eigen::Vector3f& normal, double length)
{
  const auto l = static_cast<float> (length);
  return {
      point.x(), point.y(), point.z(), l * normal.x(), l * normal.y(), l * normal.z()};
}

} // namespace

void
FeatureTree::take (const std::vector<Eigen::Vector3f>& points,
                   const std::vector<Eigen::Vector3f>& normals,
                   double normal_length)
{
  constexpr double kAlike = 2.0; // a tree's division serves lengths this far apart
  normal_length_ = normal_length;
  rows_.clear();
  rows_.reserve (6 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Feature f = featureOf (points[i], normals[i], normal_length);
    rows_.insert (rows_.end(), f.begin(), f.end());
  }
  if (tree_.size() == static_cast<int> (points.size()) &&
      normal_length < kAlike * divided_at_ && divided_at_ < kAlike * normal_length) {
    tree_.move (rows_);
    return;
  }
  tree_ = PointTree (rows_, 6);
  divided_at_ = normal_length;
}

int
FeatureTree::nearest (const Eigen::Vector3f& point,
                      const Eigen::Vector3f& normal,
                      int hint) const
{
  return tree_.nearest (featureOf (point, normal, normal_length_).data(), hint).index;
}

double
Coverage::shareOf (const std::vector<char>& flags)
{
  return static_cast<double> (std::count (flags.begin(), flags.end(), 1)) /
         static_cast<double> (std::max<std::size_t> (1, flags.size()));
}

void
PointPull::add (const Eigen::Vector3d& q,
                const Eigen::Vector3d& n,
                double share,
                double isotropy)
{
  Eigen::Matrix3d m = share * n * n.transpose();
  m.diagonal().array() += share * isotropy;
  const Eigen::Vector3d v = m * q;
  a += m;
  b += v;
  c += 0.5 * q.dot (v);
  weight += share;
}

void
PointPull::addSlope (const Eigen::Vector3d& q,
                     const Eigen::Vector3d& slope,
                     double value,
                     double share)
{
  const double at_origin = value - slope.dot (q);
  a += share * slope * slope.transpose();
  b -= share * at_origin * slope;
  c += 0.5 * share * at_origin * at_origin;
}

/** Ready for searches from the moved points, and from the target's points, too. */
void
MatchTarget::prepare (const MovedPoints& moved, double normal_length, bool both_ways)
{
  if (normal_length != normal_length_)
    tree_.take (surface_.points, surface_.normals, normal_length);
  normal_length_ = normal_length;
  if (forward_.size() != moved.points.size())
    forward_.assign (moved.points.size(), -1);
  if (!both_ways)
    return;
  moved_tree_.take (moved.points, moved.normals, normal_length);
  backward_.resize (samples_.size(), -1);
}

/** The target's point that is nearest to a moved one, -1 = none. */
int
MatchTarget::forwardMatch (const MovedPoints& moved, int i)
{
  forward_[i] = tree_.nearest (moved.points[i], moved.normals[i], forward_[i]);
  return forward_[i];
}

/** The moved point that is nearest to one of the target's samples, -1 = none. */
int
MatchTarget::backwardMatch (int sample)
{
  const int j = samples_[sample];
  backward_[sample] =
      moved_tree_.nearest (surface_.points[j], surface_.normals[j], backward_[sample]);
  return backward_[sample];
}

/** Geman-McClure's weight on the distance, none for surfaces that face each other. */
double
MatchTarget::weight (const MovedPoints& moved,
                     int i,
                     int j,
                     const MatchRules& rules) const
{
  const double facing = std::max (0.0f, moved.normals[i].dot (surface_.normals[j]));
  const Eigen::Vector3f d = moved.points[i] - surface_.points[j];
  const double s = rules.distance * rules.distance;
  double g = s / (s + d.squaredNorm());
  if (rules.plane > 0.0) {
    const double off = d.dot (surface_.normals[j]);
    g *= rules.plane * rules.plane / (rules.plane * rules.plane + off * off);
  }
  return g * g * facing * facing;
}

/** score (moved point, target's point, is it the moved one's match?) of the matches of
 * the moved points and of those of the samples; 0 without a match. */
template <typename Value, typename Score>
std::pair<std::vector<Value>, std::vector<Value>>
MatchTarget::scores (const MovedPoints& moved,
                     const MatchRules& rules,
                     int threads,
                     const Score& score)
{
  prepare (moved, rules.normal_length, true);
  std::vector<Value> forward (moved.points.size(), Value{0});
  std::vector<Value> backward (samples_.size(), Value{0});
  parallelFor (threads, static_cast<int> (forward.size()), 128, [&] (int i) {
    if (const int j = forwardMatch (moved, i); j >= 0)
      forward[i] = score (i, j, true);
  });
  parallelFor (threads, static_cast<int> (backward.size()), 128, [&] (int s) {
    if (const int i = backwardMatch (s); i >= 0)
      backward[s] = score (i, samples_[s], false);
  });
  return {std::move (forward), std::move (backward)};
}

std::vector<PointPull>
MatchTarget::pulls (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  prepare (moved, rules.normal_length, rules.mutual > 0.0 || rules.backward > 0.0);
  const int n = static_cast<int> (moved.points.size());
  std::vector<PointPull> pulls (n);
  std::vector<PointPair> forward (n);
  const auto pull = [&] (int i, int j, double share) {
    pulls[i].add (surface_.points[j].cast<double>(),
                  surface_.normals[j].cast<double>(),
                  share,
                  rules.isotropy);
  };
  parallelFor (threads, n, 128, [&] (int i) {
    const int j = forwardMatch (moved, i);
    if (j < 0 || (surface_.border[j] && !rules.borders))
      return;
    double share = weight (moved, i, j, rules);
    if (rules.mutual > 0.0 && share > 1e-6) {
      const int k = moved_tree_.nearest (surface_.points[j], surface_.normals[j], i);
      const double way = (moved.points[k] - moved.points[i]).squaredNorm();
      const double s = rules.mutual * rules.mutual;
      share *= s / (s + way) * s / (s + way);
    }
    pull (i, j, share);
    forward[i] = {i, j, share};
  });
  if (rules.brightness > 0.0)
    pullByBrightness (moved, forward, rules, pulls);
  if (!(rules.backward > 0.0))
    return pulls;
  const int m = static_cast<int> (samples_.size());
  std::vector<PointPair> matches (m);
  parallelFor (threads, m, 128, [&] (int s) {
    const int j = samples_[s];
    if (const int i = backwardMatch (s); i >= 0)
      matches[s] = {i, j, weight (moved, i, j, rules)};
  });
  const double share = rules.backward * n / std::max (1, m);
  for (const PointPair& match : matches)
    if (match.source >= 0)
      pull (match.source, match.target, share * match.weight);
  return pulls;
}

/** Points go to where the target is as bright. Their weight says how many points pull:
 * it stays as it is. */
void
MatchTarget::pullByBrightness (const MovedPoints& moved,
                               const std::vector<PointPair>& matches,
                               const MatchRules& rules,
                               std::vector<PointPull>& pulls)
{
  brightness_ = BrightnessComparison (moved,
                                      matches,
                                      surface_,
                                      texture_,
                                      rules.brightness,
                                      rules.brightness_weight,
                                      rules.outlying);
  if (!brightness_.used())
    return;
  for (const PointPair& match : matches) {
    if (match.source < 0 || !brightness_.knows (moved, match.source, match.target))
      continue;
    const Eigen::Vector3d q = surface_.points[match.target].cast<double>();
    const Eigen::Vector3d slope = brightness_.slope (match.target);
    const Eigen::Vector3d x = moved.points[match.source].cast<double>();
    const double d = brightness_.difference (moved, match.source, match.target);
    pulls[match.source].addSlope (
        q, slope, d - slope.dot (x - q), match.weight * brightness_.weight (d));
  }
}

std::pair<double, double>
MatchTarget::explained (const MovedPoints& moved,
                        const MatchRules& rules,
                        const std::vector<float>& weights,
                        int threads)
{
  auto [forward, backward] =
      scores<double> (moved, rules, threads, [&] (int i, int j, bool forward) {
        return forward && surface_.border[j] ? 0.0 : weight (moved, i, j, rules);
      });
  const auto mean = [] (const std::vector<double>& weights) {
    return std::accumulate (weights.begin(), weights.end(), 0.0) /
           static_cast<double> (std::max<std::size_t> (1, weights.size()));
  };
  if (weights.empty())
    return {mean (forward), mean (backward)};
  double all = 0.0;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    forward[i] *= weights[i];
    all += weights[i];
  }
  all = all > 0.0 ? all / static_cast<double> (forward.size()) : 1.0;
  return {mean (forward) / all, mean (backward)};
}

std::vector<float>
MatchTarget::distances (const MovedPoints& moved,
                        const MatchRules& rules,
                        double most,
                        int threads)
{
  prepare (moved, rules.normal_length, false);
  const auto limit = static_cast<float> (most);
  std::vector<float> result (moved.points.size(), limit);
  const bool bright =
      rules.brightness > 0.0 && brightness_.used() && !moved.brightness.empty();
  parallelFor (threads, static_cast<int> (result.size()), 128, [&] (int i) {
    const int j = forwardMatch (moved, i);
    if (j < 0)
      return;
    const Eigen::Vector3f d = moved.points[i] - surface_.points[j];
    if (!(d.norm() < limit && moved.normals[i].dot (surface_.normals[j]) > 0.0f))
      return;
    result[i] = std::abs (d.dot (surface_.normals[j]));
    if (bright && brightness_.knows (moved, i, j))
      result[i] = std::min (limit,
                            std::hypot (result[i],
                                        static_cast<float> (brightness_.length (
                                            brightness_.difference (moved, i, j)))));
  });
  return result;
}

Coverage
MatchTarget::covered (const MovedPoints& moved,
                      const MatchRules& rules,
                      double most,
                      int threads)
{
  Coverage coverage;
  std::tie (coverage.moved, coverage.samples) =
      scores<char> (moved, rules, threads, [&] (int i, int j, bool) {
        const bool near = (moved.points[i] - surface_.points[j]).norm() < most;
        return near && moved.normals[i].dot (surface_.normals[j]) > 0.0f;
      });
  return coverage;
}

std::vector<PointPair>
MatchTarget::tightPairs (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  prepare (moved, rules.normal_length, true);
  const int n = static_cast<int> (moved.points.size());
  std::vector<PointPair> all (n);
  parallelFor (threads, n, 128, [&] (int i) {
    const int j = forwardMatch (moved, i);
    if (j < 0 || surface_.border[j])
      return;
    const int k = moved_tree_.nearest (surface_.points[j], surface_.normals[j], i);
    if ((moved.points[k] - moved.points[i]).norm() > rules.distance)
      return;
    const double w = weight (moved, i, j, rules);
    if (w > rules.least)
      all[i] = {i, j, w};
  });
  std::vector<PointPair> pairs;
  for (const PointPair& pair : all)
    if (pair.source >= 0)
      pairs.push_back (pair);
  return pairs;
}

} // namespace pcl_msf
