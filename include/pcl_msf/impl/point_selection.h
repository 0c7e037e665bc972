// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/types.h>

#include <pcl_msf/export.h>

#include <array>
#include <cstddef>
#include <string>

namespace pcl_msf {
namespace detail {

/** Which points of a cloud to work on: all, a list of them, or a rectangle. Whether
 * they fit is judged when they are used, because a cloud's object can be filled anew in
 * between. */
class PCL_MSF_EXPORT PointSelection {
public:
  /** All points. */
  PointSelection() = default;
  explicit PointSelection (const pcl::Indices& list);
  PointSelection (std::size_t row_start,
                  std::size_t col_start,
                  std::size_t rows,
                  std::size_t cols);

  bool
  isAll () const
  {
    return kind_ == Kind::All;
  }

  /** The selected points of a cloud of `size` points, an image of width x height.
   * \param[out] points also those of a list that does not fit; none of a rectangle
   * \return why they don't fit, and the remedy; empty when they do */
  std::string
  find (std::size_t width,
        std::size_t height,
        std::size_t size,
        pcl::Indices& points) const;

private:
  enum class Kind { All, List, Rectangle };

  std::string
  findRectangle (std::size_t width, std::size_t height, pcl::Indices& points) const;

  Kind kind_{Kind::All};
  pcl::Indices list_;
  std::array<std::size_t, 4> rectangle_{}; ///< first row and column, rows, columns
};

} // namespace detail
} // namespace pcl_msf
