// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/impl/point_selection.h>

#include <algorithm>
#include <numeric>

namespace pcl_msf {
namespace detail {

namespace {

constexpr const char* kRemedy =
    ": call setIndices with some of the source's own, or with "
    "a null pointer for all points";

std::string
sizeText (std::size_t width, std::size_t height)
{
  return std::to_string (width) + "x" + std::to_string (height);
}

} // namespace

PointSelection::PointSelection (const pcl::Indices& list)
: kind_ (Kind::List), list_ (list)
{}

PointSelection::PointSelection (std::size_t row_start,
                                std::size_t col_start,
                                std::size_t rows,
                                std::size_t cols)
: kind_ (Kind::Rectangle), rectangle_{row_start, col_start, rows, cols}
{}

std::string
PointSelection::find (std::size_t width,
                      std::size_t height,
                      std::size_t size,
                      pcl::Indices& points) const
{
  points.clear();
  if (kind_ == Kind::Rectangle)
    return findRectangle (width, size >= width * height ? height : 0, points);
  if (kind_ == Kind::All) {
    points.resize (size);
    std::iota (points.begin(), points.end(), 0);
    return {};
  }
  points = list_;
  if (list_.empty())
    return std::string ("the list of indices is empty") + kRemedy;
  const auto outside =
      std::find_if (list_.begin(), list_.end(), [size] (pcl::index_t index) {
        return index < 0 || static_cast<std::size_t> (index) >= size;
      });
  if (outside == list_.end())
    return {};
  return "index " + std::to_string (*outside) + " is outside the source, which has " +
         sizeText (width, height) + " points" + kRemedy;
}

std::string
PointSelection::findRectangle (std::size_t width,
                               std::size_t height,
                               pcl::Indices& points) const
{
  const auto [row_start, col_start, rows, cols] = rectangle_;
  if (row_start > height || rows > height - row_start || col_start > width ||
      cols > width - col_start)
    return "the rectangle of indices, " + sizeText (cols, rows) + " from row " +
           std::to_string (row_start) + " and column " + std::to_string (col_start) +
           ", is not inside the source, which has " + sizeText (width, height) +
           " points" + kRemedy;
  points.reserve (rows * cols);
  for (std::size_t v = row_start; v < row_start + rows; ++v)
    for (std::size_t u = col_start; u < col_start + cols; ++u)
      points.push_back (static_cast<pcl::index_t> (v * width + u));
  return {};
}

} // namespace detail
} // namespace pcl_msf
