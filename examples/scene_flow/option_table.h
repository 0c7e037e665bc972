// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "options.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief One option of the command line. */
struct Option {
  std::string name;     ///< with the dashes
  std::string argument; ///< what follows it; empty for a switch
  std::string help;     ///< with the default

  /** \brief Takes the value; false when it does not parse. */
  std::function<bool (const std::string&)> set;
};

/** \brief A headline and the options below it. */
struct OptionGroup {
  std::string title;
  std::vector<Option> options;
};

/** \brief All options, bound to the fields of `options`, which must outlive them. */
std::vector<OptionGroup>
makeOptionTable (Options& options);

} // namespace pcl_msf::tool
