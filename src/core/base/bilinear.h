// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

namespace pcl_msf {

/** \brief Between four neighbouring values. \param a share of the right ones \param b
 * share of the lower ones, both in [0, 1] */
template <typename Share, typename Value>
constexpr Value
bilinear (Share a,
          Share b,
          const Value& upper_left,
          const Value& upper_right,
          const Value& lower_left,
          const Value& lower_right)
{
  return (Share (1) - b) * ((Share (1) - a) * upper_left + a * upper_right) +
         b * ((Share (1) - a) * lower_left + a * lower_right);
}

} // namespace pcl_msf
