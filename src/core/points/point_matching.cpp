// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_matching.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/** Geman-McClure's weight on the distance, none for surfaces that face each other. */
double
trust (const Eigen::Vector3f& x,
       const Eigen::Vector3f& n,
       const Eigen::Vector3f& q,
       const Eigen::Vector3f& m,
       const MatchRules& rules)
{
  const double facing = std::max (0.0f, n.dot (m));
  const double s = rules.distance * rules.distance;
  const double g = s / (s + (x - q).squaredNorm());
  return g * g * facing * facing;
}

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

std::vector<PointPull>
MatchTarget::pulls (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  prepare (rules.normal_length);
  const int n = static_cast<int> (moved.points.size());
  std::vector<PointPull> pulls (n);
  const PointTree own = featureTree (moved.points, moved.normals, rules.normal_length);
  parallelFor (threads, n, 128, [&] (int i) {
    const Eigen::Vector3f x = moved.points[i];
    const Feature f = featureOf (x, moved.normals[i], rules.normal_length);
    const int j = tree_.nearest (f.data()).index;
    if (j < 0 || (surface_.border[j] && !rules.borders))
      return;
    const Eigen::Vector3f q = surface_.points[j];
    double weight = trust (x, moved.normals[i], q, surface_.normals[j], rules);
    if (rules.mutual > 0.0 && weight > 1e-6) {
      const Feature back = featureOf (q, surface_.normals[j], rules.normal_length);
      const int k = own.nearest (back.data()).index;
      const double way = (moved.points[k] - x).squaredNorm();
      const double s = rules.mutual * rules.mutual;
      weight *= s / (s + way) * s / (s + way);
    }
    pulls[i].add (
        q.cast<double>(), surface_.normals[j].cast<double>(), weight, rules.isotropy);
  });
  if (!(rules.backward > 0.0))
    return pulls;
  struct Match {
    int sample{-1};
    double weight{0.0};
  };
  const int m = static_cast<int> (samples_.size());
  std::vector<Match> matches (m);
  parallelFor (threads, m, 128, [&] (int s) {
    const int j = samples_[s];
    const Feature f =
        featureOf (surface_.points[j], surface_.normals[j], rules.normal_length);
    const int i = own.nearest (f.data()).index;
    if (i >= 0)
      matches[s] = {i,
                    trust (moved.points[i],
                           moved.normals[i],
                           surface_.points[j],
                           surface_.normals[j],
                           rules)};
  });
  const double share = rules.backward * n / std::max (1, m);
  for (int s = 0; s < m; ++s)
    if (matches[s].sample >= 0)
      pulls[matches[s].sample].add (surface_.points[samples_[s]].cast<double>(),
                                    surface_.normals[samples_[s]].cast<double>(),
                                    share * matches[s].weight,
                                    rules.isotropy);
  return pulls;
}

std::pair<double, double>
MatchTarget::explained (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  prepare (rules.normal_length);
  const int n = static_cast<int> (moved.points.size());
  const int m = static_cast<int> (samples_.size());
  const PointTree own = featureTree (moved.points, moved.normals, rules.normal_length);
  std::vector<double> f (n, 0.0), b (m, 0.0);
  parallelFor (threads, n, 128, [&] (int i) {
    const Feature x =
        featureOf (moved.points[i], moved.normals[i], rules.normal_length);
    const int j = tree_.nearest (x.data()).index;
    if (j >= 0 && !surface_.border[j])
      f[i] = trust (moved.points[i],
                    moved.normals[i],
                    surface_.points[j],
                    surface_.normals[j],
                    rules);
  });
  parallelFor (threads, m, 128, [&] (int s) {
    const int j = samples_[s];
    const Feature x =
        featureOf (surface_.points[j], surface_.normals[j], rules.normal_length);
    const int i = own.nearest (x.data()).index;
    if (i >= 0)
      b[s] = trust (moved.points[i],
                    moved.normals[i],
                    surface_.points[j],
                    surface_.normals[j],
                    rules);
  });
  double fs = 0.0, bs = 0.0;
  for (const double v : f)
    fs += v;
  for (const double v : b)
    bs += v;
  return {fs / n, bs / m};
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
    const Eigen::Vector3f& x = moved.points[i];
    const Feature f = featureOf (x, moved.normals[i], rules.normal_length);
    const int j = tree_.nearest (f.data()).index;
    if (j < 0)
      return;
    const Eigen::Vector3f d = x - surface_.points[j];
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
  prepare (rules.normal_length);
  const PointTree own = featureTree (moved.points, moved.normals, rules.normal_length);
  const auto near =
      [most] (const auto& x, const auto& n, const auto& q, const auto& m) {
        return (x - q).norm() < most && n.dot (m) > 0.0f ? 1 : 0;
      };
  const int n = static_cast<int> (moved.points.size());
  const int m = static_cast<int> (samples_.size());
  const int forward = parallelSum (threads, n, 128, [&] (int i) {
    const Feature f =
        featureOf (moved.points[i], moved.normals[i], rules.normal_length);
    const int j = tree_.nearest (f.data()).index;
    return j < 0 ? 0
                 : near (moved.points[i],
                         moved.normals[i],
                         surface_.points[j],
                         surface_.normals[j]);
  });
  const int backward = parallelSum (threads, m, 128, [&] (int s) {
    const int j = samples_[s];
    const Feature f =
        featureOf (surface_.points[j], surface_.normals[j], rules.normal_length);
    const int i = own.nearest (f.data()).index;
    return i < 0 ? 0
                 : near (moved.points[i],
                         moved.normals[i],
                         surface_.points[j],
                         surface_.normals[j]);
  });
  return {static_cast<double> (forward) / std::max (1, n),
          static_cast<double> (backward) / std::max (1, m)};
}

std::vector<PointPair>
MatchTarget::tightPairs (const MovedPoints& moved, const MatchRules& rules, int threads)
{
  prepare (rules.normal_length);
  const int n = static_cast<int> (moved.points.size());
  const PointTree own = featureTree (moved.points, moved.normals, rules.normal_length);
  std::vector<PointPair> all (n);
  parallelFor (threads, n, 128, [&] (int i) {
    const Feature x =
        featureOf (moved.points[i], moved.normals[i], rules.normal_length);
    const int j = tree_.nearest (x.data()).index;
    if (j < 0 || surface_.border[j])
      return;
    const Feature y =
        featureOf (surface_.points[j], surface_.normals[j], rules.normal_length);
    const int k = own.nearest (y.data()).index;
    if ((moved.points[k] - moved.points[i]).norm() > rules.distance)
      return;
    const double w = trust (moved.points[i],
                            moved.normals[i],
                            surface_.points[j],
                            surface_.normals[j],
                            rules);
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
