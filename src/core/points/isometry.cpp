// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/isometry.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

std::vector<std::vector<float>>
distancesFrom (const Surface& surface, const std::vector<int>& anchors, int threads)
{
  std::vector<std::vector<float>> rows (anchors.size());
  parallelFor (threads, static_cast<int> (anchors.size()), 1, [&] (int a) {
    rows[a].assign (surface.size(), SurfaceGraph::kUnreached);
    surface.graph.spread (anchors[a], rows[a], [] (int, float) { return true; });
  });
  return rows;
}

} // namespace

SurfaceIsometry::SurfaceIsometry (const Surface& source,
                                  const Surface& target,
                                  const std::vector<PointPair>& pairs,
                                  double size,
                                  double least_agreement,
                                  const IsometryTuning& tuning,
                                  int threads)
: source_ (source), tuning_ (tuning), size_ (static_cast<float> (size))
{
  std::vector<int> a;
  std::vector<int> b;
  for (const PointPair& pair : pairs) {
    a.push_back (pair.source);
    b.push_back (pair.target);
  }
  source_rows_ = distancesFrom (source, a, threads);
  target_rows_ = distancesFrom (target, b, threads);
  keepConsistent (pairs, least_agreement);
}

float
SurfaceIsometry::agreement (float a, float b) const
{
  if (!std::isfinite (a) || !std::isfinite (b))
    return 0.0f;
  const float r = (a - b) / (tuning_.slack * size_ + tuning_.stretch * std::min (a, b));
  return 1.0f / (1.0f + r * r);
}

/** The pair that agrees least with the others goes, again and again. */
void
SurfaceIsometry::keepConsistent (const std::vector<PointPair>& pairs,
                                 double least_agreement)
{
  const std::size_t n = pairs.size();
  std::vector<std::vector<float>> c (n, std::vector<float> (n, 0.0f));
  std::vector<double> support (n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j) {
        c[i][j] = agreement (source_rows_[i][pairs[j].source],
                             target_rows_[i][pairs[j].target]);
        support[i] += c[i][j];
      }
  std::vector<std::size_t> alive (n);
  for (std::size_t i = 0; i < n; ++i)
    alive[i] = i;
  while (alive.size() > 3) {
    const auto worst = std::min_element (
        alive.begin(), alive.end(), [&] (std::size_t i, std::size_t j) {
          return support[i] < support[j];
        });
    if (support[*worst] >= least_agreement * static_cast<double> (alive.size() - 1))
      break;
    const std::size_t gone = *worst;
    alive.erase (worst);
    for (const std::size_t i : alive)
      support[i] -= c[i][gone];
  }
  for (std::size_t i = 0; i < alive.size(); ++i) {
    source_rows_[i].swap (source_rows_[alive[i]]);
    target_rows_[i].swap (target_rows_[alive[i]]);
  }
  source_rows_.resize (alive.size());
  target_rows_.resize (alive.size());
}

/** [0, 1] per target point: how well the distances to the anchors agree, the nearer
 * anchors counting more. */
std::vector<float>
SurfaceIsometry::scores (int source_point, const Rows& target_rows) const
{
  const int m = static_cast<int> (target_rows[0].size());
  std::vector<float> sum (m, 0.0f);
  float total = 0.0f;
  for (int r = 0; r < anchors(); ++r) {
    const float d = source_rows_[r][source_point];
    if (!std::isfinite (d))
      continue;
    const float weight = 1.0f / (tuning_.near * size_ + d);
    const float scale = 1.0f / (tuning_.slack * size_ + tuning_.stretch * d);
    const float* row = target_rows[r].data();
    total += weight;
    for (int j = 0; j < m; ++j) {
      const float x = (d - row[j]) * scale;
      sum[j] += weight / (1.0f + x * x);
    }
  }
  for (float& s : sum)
    s = total > 0.0f ? s / total : 0.0f;
  return sum;
}

std::vector<PointPair>
SurfaceIsometry::match (const std::vector<int>& source_points,
                        const std::vector<int>& target_points,
                        int threads) const
{
  const int n = static_cast<int> (source_points.size());
  const int m = static_cast<int> (target_points.size());
  if (anchors() == 0)
    return {};
  Rows rows (target_rows_.size()); // of these points alone, one after the other
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const int j : target_points)
      rows[r].push_back (target_rows_[r][j]);
  std::vector<std::vector<float>> all (n);
  parallelFor (
      threads, n, 8, [&] (int i) { all[i] = scores (source_points[i], rows); });
  std::vector<int> back (m, 0);
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < m; ++j)
      if (all[i][j] > all[back[j]][j])
        back[j] = i;
  std::vector<PointPair> pairs;
  for (int i = 0; i < n && m > 0; ++i) {
    const auto best = std::max_element (all[i].begin(), all[i].end());
    const auto j = best - all[i].begin();
    if (*best < tuning_.score)
      continue;
    const float way =
        (source_.points[source_points[back[j]]] - source_.points[source_points[i]])
            .norm() /
        (tuning_.way_back * size_);
    const float g = 1.0f / (1.0f + way * way);
    pairs.push_back ({source_points[i], target_points[j], *best * *best * g * g});
  }
  return pairs;
}

} // namespace pcl_msf
