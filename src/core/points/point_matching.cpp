// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_matching.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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

PointTree
featureTree (const std::vector<Eigen::Vector3f>& points,
             const std::vector<Eigen::Vector3f>& normals,
             double length)
{
  std::vector<float> rows;
  rows.reserve (6 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Feature f = featureOf (points[i], normals[i], length);
    rows.insert (rows.end(), f.begin(), f.end());
  }
  return PointTree (std::move (rows), 6);
}

/** The moved points, to be found by those of the target. */
class MovedTree {
public:
  MovedTree (const MovedPoints& moved, const Surface& target, double normal_length)
  : target_ (target)
  , normal_length_ (normal_length)
  , tree_ (featureTree (moved.points, moved.normals, normal_length))
  {}

  /** \return the moved point that is nearest to one of the target, -1 = none */
  int
  nearestTo (int j) const
  {
    const Feature f = featureOf (target_.points[j], target_.normals[j], normal_length_);
    return tree_.nearest (f.data()).index;
  }

private:
  const Surface& target_;
  const double normal_length_;
  const PointTree tree_;
};

} // namespace

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
MatchTarget::prepare (double normal_length)
{
  if (normal_length == normal_length_)
    return;
  tree_ = featureTree (surface_.points, surface_.normals, normal_length);
  normal_length_ = normal_length;
}

/** The target's point that is nearest to a moved one, -1 = none. */
int
MatchTarget::nearestTo (const MovedPoints& moved, int i) const
{
  const Feature f = featureOf (moved.points[i], moved.normals[i], normal_length_);
  return tree_.nearest (f.data()).index;
}

/** Geman-McClure's weight on the distance, none for surfaces that face each other. */
double
MatchTarget::weight (const MovedPoints& moved,
                     int i,
                     int j,
                     const MatchRules& rules) const
{
  const double facing = std::max (0.0f, moved.normals[i].dot (surface_.normals[j]));
  const double s = rules.distance * rules.distance;
  const double g = s / (s + (moved.points[i] - surface_.points[j]).squaredNorm());
  return g * g * facing * facing;
}

/** Mean of score (moved point, target's point, is it the moved one's match?) over the
 * matches of the moved points and over those of the samples; 0 without a match. */
template <typename Score>
std::pair<double, double>
MatchTarget::meanScores (const MovedPoints& moved,
                         const MatchRules& rules,
                         int threads,
                         const Score& score)
{
  prepare (rules.normal_length);
  const MovedTree own (moved, surface_, rules.normal_length);
  std::vector<double> forward (moved.points.size(), 0.0);
  std::vector<double> backward (samples_.size(), 0.0);
  parallelFor (threads, static_cast<int> (forward.size()), 128, [&] (int i) {
    if (const int j = nearestTo (moved, i); j >= 0)
      forward[i] = score (i, j, true);
  });
  parallelFor (threads, static_cast<int> (backward.size()), 128, [&] (int s) {
    if (const int i = own.nearestTo (samples_[s]); i >= 0)
      backward[s] = score (i, samples_[s], false);
  });
  const auto mean = [] (const std::vector<double>& scores) {
    return std::accumulate (scores.begin(), scores.end(), 0.0) /
           static_cast<double> (std::max<std::size_t> (1, scores.size()));
  };
  return {mean (forward), mean (backward)};
}

std::vector<PointPull>
MatchTarget::pulls (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  prepare (rules.normal_length);
  const int n = static_cast<int> (moved.points.size());
  std::vector<PointPull> pulls (n);
  const MovedTree own (moved, surface_, rules.normal_length);
  const auto pull = [&] (int i, int j, double share) {
    pulls[i].add (surface_.points[j].cast<double>(),
                  surface_.normals[j].cast<double>(),
                  share,
                  rules.isotropy);
  };
  parallelFor (threads, n, 128, [&] (int i) {
    const int j = nearestTo (moved, i);
    if (j < 0 || (surface_.border[j] && !rules.borders))
      return;
    double share = weight (moved, i, j, rules);
    if (rules.mutual > 0.0 && share > 1e-6) {
      const int k = own.nearestTo (j);
      const double way = (moved.points[k] - moved.points[i]).squaredNorm();
      const double s = rules.mutual * rules.mutual;
      share *= s / (s + way) * s / (s + way);
    }
    pull (i, j, share);
  });
  if (!(rules.backward > 0.0))
    return pulls;
  const int m = static_cast<int> (samples_.size());
  std::vector<PointPair> matches (m);
  parallelFor (threads, m, 128, [&] (int s) {
    const int j = samples_[s];
    if (const int i = own.nearestTo (j); i >= 0)
      matches[s] = {i, j, weight (moved, i, j, rules)};
  });
  const double share = rules.backward * n / std::max (1, m);
  for (const PointPair& match : matches)
    if (match.source >= 0)
      pull (match.source, match.target, share * match.weight);
  return pulls;
}

std::pair<double, double>
MatchTarget::explained (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  return meanScores (moved, rules, threads, [&] (int i, int j, bool forward) {
    return forward && surface_.border[j] ? 0.0 : weight (moved, i, j, rules);
  });
}

std::vector<float>
MatchTarget::distances (const MovedPoints& moved,
                        const MatchRules& rules,
                        double most,
                        int threads)
{
  prepare (rules.normal_length);
  const auto limit = static_cast<float> (most);
  std::vector<float> result (moved.points.size(), limit);
  parallelFor (threads, static_cast<int> (result.size()), 128, [&] (int i) {
    const int j = nearestTo (moved, i);
    if (j < 0)
      return;
    const Eigen::Vector3f d = moved.points[i] - surface_.points[j];
    if (d.norm() < limit && moved.normals[i].dot (surface_.normals[j]) > 0.0f)
      result[i] = std::abs (d.dot (surface_.normals[j]));
  });
  return result;
}

std::pair<double, double>
MatchTarget::covered (const MovedPoints& moved,
                      const MatchRules& rules,
                      double most,
                      int threads)
{
  return meanScores (moved, rules, threads, [&] (int i, int j, bool) {
    const bool near = (moved.points[i] - surface_.points[j]).norm() < most;
    return near && moved.normals[i].dot (surface_.normals[j]) > 0.0f ? 1.0 : 0.0;
  });
}

std::vector<PointPair>
MatchTarget::tightPairs (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  prepare (rules.normal_length);
  const int n = static_cast<int> (moved.points.size());
  const MovedTree own (moved, surface_, rules.normal_length);
  std::vector<PointPair> all (n);
  parallelFor (threads, n, 128, [&] (int i) {
    const int j = nearestTo (moved, i);
    if (j < 0 || surface_.border[j])
      return;
    const int k = own.nearestTo (j);
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
