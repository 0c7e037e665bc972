// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <cstddef>
#include <string>

namespace pcl_msf::testing {

/** The bytes of a literal, zeros in it included. */
template <std::size_t N>
std::string
bytes (const char (&literal)[N])
{
  return std::string (literal, N - 1);
}

} // namespace pcl_msf::testing
