// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace pcl_msf {

/** \brief A tuned value by its name: where it is kept and what it may be. */
struct TunedValue {
  std::string name; ///< stage.part.value, as options of the tools give it
  std::variant<int*, float*, double*> place;
  double least; ///< the range, with both ends
  double most;
};

using TunedValues = std::vector<TunedValue>;

} // namespace pcl_msf
