// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include <CLI/App.hpp>

#include <limits>

namespace pcl_msf::tool {

/** \brief For a number of [low, high], or above low; the help shows it. */
inline CLI::Validator
inRange (double low, double high, const std::string& words)
{
  const auto problem = [low, high, words] (const std::string& text) {
    double value = 0.0;
    const bool fits = !parse (text, value) || (value >= low && value <= high);
    return fits ? std::string() : text + ", must be " + words;
  };
  return {problem, words};
}

inline CLI::Validator
within (double low, double high)
{
  return inRange (low, high, presetText (low) + " to " + presetText (high));
}

inline CLI::Validator
atLeast (double low)
{
  return inRange (low, std::numeric_limits<double>::max(), ">= " + presetText (low));
}

inline CLI::Validator
above (double low)
{
  return inRange (std::nextafter (low, std::numeric_limits<double>::max()),
                  std::numeric_limits<double>::max(),
                  "> " + presetText (low));
}

} // namespace pcl_msf::tool
