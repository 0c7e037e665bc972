// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/point_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

namespace pcl_msf {

namespace {

constexpr int kLeaf = 8;  // points at the most
constexpr int kDeep = 32; // levels at the most
constexpr float kFar = std::numeric_limits<float>::infinity();

/** A point, or a box's corner, in as many numbers as registers take at once. */
template <int Width>
using Row = Eigen::Array<float, Width, 1>;

template <int Width>
Eigen::Map<const Row<Width>>
row (const float* numbers)
{
  return Eigen::Map<const Row<Width>> (numbers);
}

template <int Width>
inline float
squaredDistance (const Row<Width>& query, const float* point)
{
  return (row<Width> (point) - query).square().sum();
}

/** Rounded, too, no more than that to a point in the box. */
template <int Width>
inline float
squaredDistanceToBox (const Row<Width>& query, const float* box)
{
  const auto below = row<Width> (box) - query;
  const auto above = query - row<Width> (box + Width);
  return below.max (above).max (0.0f).square().sum();
}

class Nearest {
public:
  float
  bound () const
  {
    return found_.squared_distance;
  }
  void
  offer (float squared_distance, int index)
  {
    if (squared_distance < found_.squared_distance ||
        (squared_distance == found_.squared_distance && index < found_.index))
      found_ = {index, squared_distance};
  }
  FoundPoint
  found () const
  {
    return found_;
  }

private:
  FoundPoint found_{-1, kFar};
};

class NearestFew {
public:
  NearestFew (int count, std::vector<FoundPoint>& found)
  : count_ (count), found_ (found)
  {}
  float
  bound () const
  {
    return bound_;
  }
  void
  offer (float squared_distance, int index)
  {
    const auto before = [&] (const FoundPoint& f) {
      return std::tie (f.squared_distance, f.index) <
             std::tie (squared_distance, index);
    };
    if (static_cast<int> (found_.size()) == count_) {
      if (before (found_.back()))
        return;
      found_.pop_back();
    }
    auto place = found_.end();
    while (place != found_.begin() && !before (*(place - 1)))
      --place;
    found_.insert (place, {index, squared_distance});
    if (static_cast<int> (found_.size()) == count_)
      bound_ = found_.back().squared_distance;
  }

private:
  int count_;
  float bound_{kFar};
  std::vector<FoundPoint>& found_;
};

} // namespace

/** Complete and binary: the boxes in a box are 2 i + 1 and 2 i + 2. */
struct PointTree::Boxes {
  int dimensions;
  int size;
  int width;                ///< of a row: 4 or 8, the rest is 0
  int leaves{1};            ///< a power of two
  std::vector<int> order;   ///< the points' indices, leaf by leaf
  std::vector<int> place;   ///< of an index in that order
  std::vector<float> rows;  ///< in that order
  std::vector<float> sides; ///< per box a row for either corner

  Boxes (const std::vector<float>& coordinates, int columns)
  : dimensions (columns)
  , size (static_cast<int> (coordinates.size()) / columns)
  , width (columns <= 4 ? 4 : 8)
  , order (size)
  , place (size)
  , rows (static_cast<std::size_t> (size) * width, 0.0f)
  {
    while (leaves * kLeaf < size)
      leaves *= 2;
    sides.resize (static_cast<std::size_t> (2 * leaves - 1) * 2 * width);
    std::iota (order.begin(), order.end(), 0);
    divide (coordinates, 0, leaves);
    for (int i = 0; i < size; ++i)
      place[order[i]] = i;
    move (coordinates);
  }

  /** First point of a leaf. */
  int
  begin (int leaf) const
  {
    return static_cast<int> (static_cast<std::int64_t> (size) * leaf / leaves);
  }
  const float*
  rowAt (int at) const
  {
    return &rows[static_cast<std::size_t> (at) * width];
  }
  const float*
  side (int box) const
  {
    return &sides[static_cast<std::size_t> (box) * 2 * width];
  }

  /** Halves the leaves' points across the widest dimension, again and again. */
  void
  divide (const std::vector<float>& coordinates, int first, int last)
  {
    if (last - first < 2)
      return;
    const auto coordinate = [&] (int index, int d) {
      return coordinates[static_cast<std::size_t> (index) * dimensions + d];
    };
    int widest = 0;
    float extent = -1.0f;
    for (int d = 0; d < dimensions; ++d) {
      float low = kFar;
      float high = -kFar;
      for (int i = begin (first); i < begin (last); ++i) {
        low = std::min (low, coordinate (order[i], d));
        high = std::max (high, coordinate (order[i], d));
      }
      if (high - low > extent) {
        extent = high - low;
        widest = d;
      }
    }
    const int middle = (first + last) / 2;
    std::nth_element (
        order.begin() + begin (first),
        order.begin() + begin (middle),
        order.begin() + begin (last),
        [&] (int a, int b) { return coordinate (a, widest) < coordinate (b, widest); });
    divide (coordinates, first, middle);
    divide (coordinates, middle, last);
  }

  void
  move (const std::vector<float>& coordinates)
  {
    for (int i = 0; i < size; ++i)
      std::copy_n (&coordinates[static_cast<std::size_t> (order[i]) * dimensions],
                   dimensions,
                   &rows[static_cast<std::size_t> (i) * width]);
    width == 4 ? drawBoxes<4>() : drawBoxes<8>();
  }

  /** Draws all boxes around their points, the smallest first. */
  template <int Width>
  void
  drawBoxes ()
  {
    for (int box = 2 * leaves - 2; box >= 0; --box) {
      Row<Width> low = Row<Width>::Constant (kFar);
      Row<Width> high = Row<Width>::Constant (-kFar);
      if (const int leaf = box - (leaves - 1); leaf >= 0)
        for (int i = begin (leaf); i < begin (leaf + 1); ++i) {
          low = low.min (row<Width> (rowAt (i)));
          high = high.max (row<Width> (rowAt (i)));
        }
      else
        for (const int inner : {2 * box + 1, 2 * box + 2}) {
          low = low.min (row<Width> (side (inner)));
          high = high.max (row<Width> (side (inner) + Width));
        }
      float* corners = &sides[static_cast<std::size_t> (box) * 2 * Width];
      std::copy_n (low.data(), Width, corners);
      std::copy_n (high.data(), Width, corners + Width);
    }
  }

  template <int Width>
  Row<Width>
  widened (const float* numbers) const
  {
    Row<Width> wide = Row<Width>::Zero();
    std::copy_n (numbers, dimensions, wide.data());
    return wide;
  }

  template <int Width, typename Result>
  void
  search (const Row<Width>& query, Result& result) const
  {
    std::array<std::pair<float, int>, kDeep> waiting;
    int count = 0;
    waiting[count++] = {0.0f, 0};
    while (count > 0) {
      auto [distance, box] = waiting[--count];
      while (distance <= result.bound() && box < leaves - 1) {
        const int held = 2 * box + 1;
        const float first = squaredDistanceToBox<Width> (query, side (held));
        const float second = squaredDistanceToBox<Width> (query, side (held + 1));
        const bool swapped = second < first;
        waiting[count++] = {swapped ? first : second, swapped ? held : held + 1};
        distance = swapped ? second : first;
        box = swapped ? held + 1 : held;
      }
      if (!(distance <= result.bound()))
        continue;
      const int leaf = box - (leaves - 1);
      for (int i = begin (leaf); i < begin (leaf + 1); ++i)
        result.offer (squaredDistance<Width> (query, rowAt (i)), order[i]);
    }
  }

  template <int Width>
  FoundPoint
  nearest (const float* numbers, int hint) const
  {
    const Row<Width> query = widened<Width> (numbers);
    Nearest result;
    if (hint >= 0 && hint < size)
      result.offer (squaredDistance<Width> (query, rowAt (place[hint])), hint);
    search<Width> (query, result);
    return result.found();
  }

  bool
  accepts (const float* query) const
  {
    return std::all_of (
        query, query + dimensions, [] (float v) { return std::isfinite (v); });
  }
};

PointTree::PointTree() = default;
PointTree::~PointTree() = default;
PointTree::PointTree (PointTree&&) noexcept = default;
PointTree&
PointTree::operator= (PointTree&&) noexcept = default;

PointTree::PointTree (const std::vector<Eigen::Vector3f>& points)
{
  std::vector<float> coordinates;
  coordinates.reserve (3 * points.size());
  for (const auto& p : points)
    coordinates.insert (coordinates.end(), p.data(), p.data() + 3);
  *this = PointTree (coordinates, 3);
}

PointTree::PointTree (const std::vector<float>& coordinates, int dimensions)
{
  if (!coordinates.empty())
    boxes_ = std::make_unique<Boxes> (coordinates, dimensions);
}

int
PointTree::size() const
{
  return boxes_ ? boxes_->size : 0;
}

void
PointTree::move (const std::vector<float>& coordinates)
{
  if (boxes_)
    boxes_->move (coordinates);
}

FoundPoint
PointTree::nearest (const float* query, int hint) const
{
  if (!boxes_ || !boxes_->accepts (query))
    return {};
  return boxes_->width == 4 ? boxes_->nearest<4> (query, hint)
                            : boxes_->nearest<8> (query, hint);
}

void
PointTree::nearest (const float* query, int count, std::vector<FoundPoint>& found) const
{
  found.clear();
  if (!boxes_ || count < 1 || !boxes_->accepts (query))
    return;
  NearestFew result (count, found);
  if (boxes_->width == 4)
    boxes_->search<4> (boxes_->widened<4> (query), result);
  else
    boxes_->search<8> (boxes_->widened<8> (query), result);
}

} // namespace pcl_msf
