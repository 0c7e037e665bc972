// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data/correlation_area.h"

#include "core/base/parallel_for.h"
#include "core/data/point_residuals.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_msf {

namespace {

constexpr int kBodies = 3;            // in one square
constexpr double kMedianOf1 = 0.4549; // of chi-square with one degree of freedom
constexpr double kMedianOf2 = 0.6931; // half of that with two, its mean being 1

/** A body's part of a square. */
struct Tile {
  int body{-1};
  int points{0};
  double icp{0.0}, icp_weight{0.0}; // sum of w r and of w
  double bright_u{0.0}, bright_v{0.0}, bright_weight{0.0};
};

/** Ratios of squared sums to what they would be, with the information as weight. */
using Ratios = std::vector<std::pair<double, double>>;

double
weightedMedian (Ratios& ratios)
{
  std::sort (ratios.begin(), ratios.end());
  double total = 0.0;
  for (const auto& ratio : ratios)
    total += ratio.second;
  double sum = 0.0;
  for (const auto& ratio : ratios) {
    sum += ratio.second;
    if (sum >= 0.5 * total)
      return ratio.first;
  }
  return 0.0;
}

class TileSums {
public:
  TileSums (const DataTerm& data, int side)
  : data_ (data)
  , image_ (data.image())
  , side_ (side)
  , columns_ ((image_.width + side - 1) / side)
  , tiles_ (static_cast<std::size_t> (columns_) * ((image_.height + side - 1) / side) *
            kBodies)
  {}

  /** \brief Adds points at a state's poses, those of some rows of tiles, in parallel.
   */
  void
  add (const MotionState& state, int most_rows, int threads);
  /** \param least points of a body's part of a square */
  void
  collect (double least, Ratios& brightness, Ratios& icp) const;

private:
  void
  addRow (const MotionState& state, int row);
  void
  add (int body, int segment, int point, const PointResiduals& residuals);
  Tile*
  tileOf (int pixel, int body);

  const DataTerm& data_;
  const kernel::Image image_;
  const int side_;
  const int columns_;
  std::vector<Tile> tiles_;
};

/** Null for bodies of a square beyond the first few. */
Tile*
TileSums::tileOf (int pixel, int body)
{
  const int column = pixel % image_.width / side_;
  const int row = pixel / image_.width / side_;
  Tile* tile = &tiles_[(static_cast<std::size_t> (row) * columns_ + column) * kBodies];
  for (int i = 0; i < kBodies; ++i, ++tile)
    if (tile->body == body || tile->body < 0) {
      tile->body = body;
      return tile;
    }
  return nullptr;
}

void
TileSums::add (const MotionState& state, int most_rows, int threads)
{
  const int rows = (image_.height + side_ - 1) / side_;
  const int step = std::max (1, rows / most_rows);
  parallelFor (threads, rows / step, 1, [&] (int row) {
    addRow (state, row * step + step / 2);
  });
}

/** Adds what lies in a row of tiles; a segment's points are in raster order. */
void
TileSums::addRow (const MotionState& state, int row)
{
  const SegmentPixels& p = data_.pixels();
  const int first = row * side_ * image_.width;
  const int last = first + side_ * image_.width;
  for (int k = 0; k < p.segments(); ++k) {
    const auto begin = p.pixel.begin() + p.begin[k];
    const auto end = p.pixel.begin() + p.begin[k + 1];
    if (begin == end || *begin >= last || *(end - 1) < first)
      continue;
    const PointRange range{
        static_cast<int> (std::lower_bound (begin, end, first) - p.pixel.begin()),
        static_cast<int> (std::lower_bound (begin, end, last) - p.pixel.begin())};
    const int body = state.body_of[k];
    forEachSeen (data_,
                 state.poseOf (k),
                 range,
                 [&] (int point, const PointResiduals& r) { add (body, k, point, r); });
  }
}

void
TileSums::add (int body, int segment, int point, const PointResiduals& residuals)
{
  const SegmentPixels& p = data_.pixels();
  Tile* tile = tileOf (p.pixel[point], body);
  if (!tile)
    return;
  const auto worth = static_cast<float> (p.pixels_per_point[segment]);
  tile->points += p.pixels_per_point[segment];
  const float limit = data_.rules().huber;
  const auto weight = [limit, worth] (float r) {
    return worth * std::min (1.0f, limit / std::max (std::abs (r), 1e-6f)); // of Eq. 7
  };
  if (p.icp_scale[point] > 0.0f) {
    const float w = weight (residuals.icp);
    tile->icp += w * residuals.icp;
    tile->icp_weight += w;
  }
  const ImagePlace& at = residuals.at;
  const bool inside = at.u >= 0.5f && at.v >= 0.5f &&
                      at.u < static_cast<float> (image_.width) - 1.5f &&
                      at.v < static_cast<float> (image_.height) - 1.5f;
  if (!(p.brightness_scale[point] > 0.0f) || !inside)
    return;
  const float w = weight (residuals.brightness);
  const float scale = p.brightness_scale[point];
  const float gu = scale * (intensityAt (image_, {at.u + 0.5f, at.v}) -
                            intensityAt (image_, {at.u - 0.5f, at.v}));
  const float gv = scale * (intensityAt (image_, {at.u, at.v + 0.5f}) -
                            intensityAt (image_, {at.u, at.v - 0.5f}));
  tile->bright_u += w * residuals.brightness * gu;
  tile->bright_v += w * residuals.brightness * gv;
  tile->bright_weight += w * (gu * gu + gv * gv);
}

void
TileSums::collect (double least, Ratios& brightness, Ratios& icp) const
{
  for (const Tile& tile : tiles_) {
    if (tile.points < least)
      continue;
    if (tile.icp_weight > 0.0)
      icp.emplace_back (tile.icp * tile.icp / tile.icp_weight, tile.icp_weight);
    const double sum = tile.bright_u * tile.bright_u + tile.bright_v * tile.bright_v;
    if (tile.bright_weight > 0.0)
      brightness.emplace_back (sum / tile.bright_weight, tile.bright_weight);
  }
}

} // namespace

CorrelationAreas
measureCorrelationAreas (const std::vector<PairTerms>& terms,
                         const WindowState& state,
                         int level,
                         const CorrelationAreas& before,
                         const CorrelationTuning& tuning,
                         int threads)
{
  Ratios brightness;
  Ratios icp;
  for (const PairTerms& pair : fromReference (terms)) {
    const int side = std::max (1, tuning.tile >> level);
    TileSums sums (*pair.all, side);
    sums.add (state.ofPair (pair.pair), tuning.most_rows, threads);
    sums.collect (tuning.least_filled * side * side, brightness, icp);
  }
  const double pixels = 1 << (2 * level); // of level 0 in one of the level
  const auto area = [&] (Ratios& ratios, double median, double otherwise) {
    if (static_cast<int> (ratios.size()) < tuning.least_tiles)
      return otherwise;
    return std::max (1.0, pixels * weightedMedian (ratios) / median);
  };
  return {area (brightness, kMedianOf2, before.brightness),
          area (icp, kMedianOf1, before.icp)};
}

} // namespace pcl_msf
