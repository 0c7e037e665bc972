// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl_msf {

/** \brief Standard deviation of Gaussian noise by its median absolute deviation. */
inline constexpr double kMadToSigma = 1.4826;

/** \brief The value with n smaller ones before it. Changes the values' order. \param n
 * less than their number */
template <typename Value>
Value
nthSmallest (std::vector<Value>& values, std::size_t n)
{
  const auto nth = values.begin() + static_cast<std::ptrdiff_t> (n);
  std::nth_element (values.begin(), nth, values.end());
  return *nth;
}

/** \brief The value in the middle, the upper one of two. Changes the values' order.
 * \param values one or more */
template <typename Value>
Value
median (std::vector<Value>& values)
{
  return nthSmallest (values, values.size() / 2);
}

/** \brief The value that a share of the others is below, the lower one of two. Changes
 * the values' order. \param values one or more \param share in [0, 1] */
template <typename Value>
Value
quantile (std::vector<Value>& values, double share)
{
  return nthSmallest (values, static_cast<std::size_t> (share * (values.size() - 1)));
}

} // namespace pcl_msf
