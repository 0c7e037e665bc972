// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/common_errors.h"

#include <Eigen/Eigenvalues>

#include "core/base/flatten.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl_msf {

namespace {

constexpr double kFreedom = 1e-9; // share of the largest eigenvalue

/** A segment's share in its body's score, and where it is. */
struct Score {
  double x, y; ///< middle, pixels
  int points;
  Vector6 score; ///< b, in units of independent deviations
};

/** What tiles of one size say about a body. */
struct TileStatistics {
  int tiles{0};
  double points{0.0};      ///< of a tile, mean over points
  double correlation{0.0}; ///< r, may be negative
};

Score
scoreOf (const DataTerm& data, int segment, double residual_scale)
{
  const SegmentPixels& p = data.pixels();
  const int width = data.image().width;
  Score score{
      0.0, 0.0, p.pixels (segment), residual_scale * data.of (segment).gradient};
  for (int i = p.begin[segment]; i < p.begin[segment + 1]; ++i) {
    score.x += p.pixel[i] % width;
    score.y += p.pixel[i] / width;
  }
  score.x /= std::max (1, p.size (segment));
  score.y /= std::max (1, p.size (segment));
  return score;
}

/** F with F F' = inverse of A where A says something, scaled so that radians and metres
 * compare. Flat as the factor of a CompressedBlock. */
PCL_MSF_FLATTEN Matrix6
inverseFactor (const Matrix6& a)
{
  const Vector6 scale = a.diagonal().cwiseMax (1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::Matrix<double, 6, 6> scaled =
      scale.asDiagonal() * a * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen (scaled);
  Matrix6 factor = Matrix6::Zero();
  for (int i = 0; i < 6; ++i)
    if (eigen.eigenvalues()[i] > kFreedom * eigen.eigenvalues()[5])
      factor.col (i) = scale.cwiseProduct (eigen.eigenvectors().col (i)) /
                       std::sqrt (eigen.eigenvalues()[i]);
  return factor;
}

/** \param factor of the body's inverse information */
TileStatistics
statisticsOf (const std::vector<Score>& scores,
              const Vector6& mean,
              const Matrix6& factor,
              double side)
{
  std::map<std::pair<int, int>, std::pair<Vector6, double>> tiles;
  double points = 0.0;
  for (const Score& s : scores) {
    auto& [sum, n] = tiles
                         .try_emplace ({static_cast<int> (s.y / side),
                                        static_cast<int> (s.x / side)},
                                       Vector6::Zero(),
                                       0.0)
                         .first->second;
    sum += s.score - s.points * mean;
    n += s.points;
    points += s.points;
  }
  TileStatistics result;
  result.tiles = static_cast<int> (tiles.size());
  double squares = 0.0;
  for (const auto& tile : tiles) {
    squares += (factor.transpose() * tile.second.first).squaredNorm() / 6.0;
    result.points += tile.second.second * tile.second.second / points;
  }
  if (result.tiles > 1)
    squares *= result.tiles / (result.tiles - 1.0); // their sum is zero
  result.correlation = (squares - 1.0) / std::max (result.points - 1.0, 1.0);
  return result;
}

/** Of the largest tiles that are enough, of the smallest otherwise. */
TileStatistics
statisticsOf (const std::vector<Score>& scores,
              const Matrix6& information,
              double side,
              const InformationTuning& tuning)
{
  Vector6 mean = Vector6::Zero();
  double points = 0.0;
  for (const Score& s : scores) {
    mean += s.score;
    points += s.points;
  }
  mean /= std::max (1.0, points);
  const Matrix6 factor = inverseFactor (information);
  TileStatistics result = statisticsOf (scores, mean, factor, side);
  while (result.tiles < tuning.enough_tiles &&
         side / tuning.smaller >= tuning.least_tile) {
    side /= tuning.smaller;
    result = statisticsOf (scores, mean, factor, side);
  }
  if (2 * result.tiles < tuning.enough_tiles) // too few to tell
    return {};
  return result;
}

} // namespace

std::vector<BodyInformation>
informationOfBodies (const DataTerm& data,
                     const MotionState& state,
                     double residual_scale,
                     const InformationTuning& tuning)
{
  std::vector<BodyInformation> bodies (state.poses.size());
  std::vector<std::vector<Score>> scores (bodies.size());
  for (int k = 0; k < data.pixels().segments(); ++k) {
    if (data.pixels().size (k) == 0)
      continue;
    BodyInformation& body = bodies[state.body_of[k]];
    body.data += residual_scale * data.of (k).information;
    body.points += data.pixels().pixels (k);
    scores[state.body_of[k]].push_back (scoreOf (data, k, residual_scale));
  }
  const double area = static_cast<double> (data.image().width) * data.image().height;
  std::vector<TileStatistics> own;
  double tiles = 0.0;
  double sum = 0.0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    own.push_back (statisticsOf (
        scores[b], bodies[b].data, std::sqrt (area / tuning.tiles), tuning));
    tiles += own[b].tiles;
    sum += own[b].tiles * own[b].correlation;
  }
  const double pooled = sum / std::max (1.0, tiles);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double weight = own[b].tiles + tuning.pooled;
    const double correlation =
        (own[b].tiles * own[b].correlation + tuning.pooled * pooled) /
        std::max (1.0, weight);
    bodies[b].excess = std::max (1.0, 1.0 + (bodies[b].points - 1.0) * correlation);
  }
  return bodies;
}

} // namespace pcl_msf
