// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/surface_normals.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace pcl_msf {

namespace {

constexpr double kFlat = 0.01;  // of a piece's reach: less volume is noise
constexpr double kScrap = 0.05; // share of the points: smaller pieces are of a body
/** Lies on one side of most flat pieces, those along the axes' planes among them. */
const Eigen::Vector3d kOneSide (0.36, 0.48, 0.80);

using Points = std::vector<Eigen::Vector3f>;
using Neighbors = std::vector<std::vector<FoundPoint>>;

Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
localScatter (const Points& points, int i, const std::vector<FoundPoint>& neighbors)
{
  Eigen::Vector3d mean = points[i].cast<double>();
  for (const FoundPoint& f : neighbors)
    mean += points[f.index].cast<double>();
  mean /= static_cast<double> (neighbors.size() + 1);
  Eigen::Vector3d d = points[i].cast<double>() - mean;
  Eigen::Matrix3d scatter = d * d.transpose();
  for (const FoundPoint& f : neighbors) {
    d = points[f.index].cast<double>() - mean;
    scatter += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect (scatter / std::max (scatter.trace(), 1e-300));
  return eigen;
}

/** How uncertain it is that two normals look to the same side when their product is
 * positive: small on a plane, large over an edge or a gap. */
float
ambiguity (const Points& points, const Points& normals, int a, int b)
{
  const Eigen::Vector3f edge = (points[b] - points[a]).normalized();
  return 1.0f - std::abs (normals[a].dot (normals[b])) +
         0.5f * std::abs (edge.dot (normals[a])) +
         0.5f * std::abs (edge.dot (normals[b]));
}

std::vector<std::vector<int>>
bothWays (const Neighbors& neighbors)
{
  std::vector<int> sizes;
  for (const auto& found : neighbors)
    sizes.push_back (static_cast<int> (found.size()));
  for (const auto& found : neighbors)
    for (const FoundPoint& f : found)
      ++sizes[f.index];
  std::vector<std::vector<int>> lists (neighbors.size());
  for (std::size_t i = 0; i < lists.size(); ++i)
    lists[i].reserve (sizes[i]);
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    for (const FoundPoint& f : neighbors[i]) {
      lists[i].push_back (f.index);
      lists[f.index].push_back (static_cast<int> (i));
    }
  return lists;
}

/** Does a step lead through a gap or a thin part, along both normals? */
bool
leapsOff (const Points& points, const Points& normals, int a, int b, float steep)
{
  const Eigen::Vector3f edge = (points[b] - points[a]).normalized();
  return std::abs (edge.dot (normals[a])) > steep &&
         std::abs (edge.dot (normals[b])) > steep;
}

/** Turns a piece's normals to one side, going from the surest neighbour to the next.
 * \param surest per point the least ambiguity of a step to it so far, and from where */
void
turnPiece (int first,
           const Points& points,
           const std::vector<std::vector<int>>& lists,
           float steep,
           Points& normals,
           std::vector<char>& done,
           std::vector<std::pair<float, int>>& surest,
           std::vector<int>& piece)
{
  using Step = std::tuple<float, int, int>; // ambiguity, to, from
  std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
  queue.push ({0.0f, first, first});
  while (!queue.empty()) {
    const auto [unused, to, from] = queue.top();
    queue.pop();
    if (done[to])
      continue;
    done[to] = 1;
    piece.push_back (to);
    if (normals[to].dot (normals[from]) < 0.0f)
      normals[to] = -normals[to];
    for (const int next : lists[to]) {
      if (done[next] || leapsOff (points, normals, to, next, steep))
        continue;
      const std::pair<float, int> step (ambiguity (points, normals, to, next), to);
      if (step < surest[next]) { // others would come too late
        surest[next] = step;
        queue.push ({step.first, next, to});
      }
    }
  }
}

/** Outwards: where the volume inside, a sum over the surface, is positive. An open
 * piece that is flat has none but noise: it faces one side of the axes, so that another
 * sample of it faces the same. */
void
turnOutwards (const Points& points,
              const Neighbors& neighbors,
              const std::vector<int>& piece,
              Points& normals)
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const int i : piece)
    center += points[i].cast<double>();
  center /= static_cast<double> (piece.size());
  double volume = 0.0;
  double reach = 0.0; // the volume that it would have at right angles to its places
  double all = 0.0;
  Eigen::Vector3d facing = Eigen::Vector3d::Zero();
  for (const int i : piece) {
    const double area =
        neighbors[i].empty() ? 0.0 : neighbors[i].back().squared_distance;
    const Eigen::Vector3d place = points[i].cast<double>() - center;
    volume += area * normals[i].cast<double>().dot (place);
    reach += area * place.norm();
    facing += area * normals[i].cast<double>();
    all += area;
  }
  const bool scrap =
      static_cast<double> (piece.size()) < kScrap * static_cast<double> (points.size());
  if (!scrap && std::abs (volume) < kFlat * reach && facing.norm() > 0.5 * all)
    volume = facing.dot (kOneSide);
  if (volume < 0.0)
    for (const int i : piece)
      normals[i] = -normals[i];
}

bool
isDirection (const Eigen::Vector3f& vector)
{
  return vector.allFinite() && vector.cwiseAbs().maxCoeff() > 0.0f;
}

/** Unit, to either side. */
Eigen::Vector3f
planeNormal (const Points& points, int i, const std::vector<FoundPoint>& neighbors)
{
  const Eigen::Vector3f normal =
      localScatter (points, i, neighbors).eigenvectors().col (0).cast<float>();
  if (!normal.allFinite() || normal.norm() < 0.5f)
    return Eigen::Vector3f::UnitZ();
  return normal.normalized();
}

} // namespace

std::vector<Eigen::Vector3f>
surfaceNormals (const Points& points,
                const Neighbors& neighbors,
                const SurfaceTuning& tuning,
                int threads,
                const Points& given)
{
  Points normals (points.size());
  parallelFor (threads, static_cast<int> (points.size()), 256, [&] (int i) {
    normals[i] = !given.empty() && isDirection (given[i])
                     ? given[i].stableNormalized().eval()
                     : planeNormal (points, i, neighbors[i]);
  });
  const std::vector<std::vector<int>> lists = bothWays (neighbors);
  std::vector<char> done (points.size(), 0);
  std::vector<std::pair<float, int>> surest (
      points.size(), {std::numeric_limits<float>::infinity(), 0});
  std::vector<int> piece;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!done[i]) {
      piece.clear();
      turnPiece (static_cast<int> (i),
                 points,
                 lists,
                 tuning.leap,
                 normals,
                 done,
                 surest,
                 piece);
      turnOutwards (points, neighbors, piece, normals);
    }
  return normals;
}

PlaneFit
fitNeighbors (const Points& points, int point, const std::vector<FoundPoint>& neighbors)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const FoundPoint& f : neighbors)
    mean += points[f.index].cast<double>();
  mean /= std::max<std::size_t> (1, neighbors.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const FoundPoint& f : neighbors) {
    const Eigen::Vector3d d = points[f.index].cast<double>() - mean;
    scatter += d * d.transpose();
  }
  scatter /= std::max<std::size_t> (1, neighbors.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen (scatter);
  const Eigen::Vector3d d = points[point].cast<double>() - mean;
  return {static_cast<float> (std::abs (eigen.eigenvectors().col (0).dot (d))),
          static_cast<float> (std::sqrt (std::max (0.0, eigen.eigenvalues()[0])))};
}

} // namespace pcl_msf
