// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <string>
#include <vector>

namespace pcl_msf::benchmarks {

/** \brief A kernel's function on one core, and what the machine would allow. */
struct KernelSpeed {
  std::string name; ///< "linearize x86-64-v4"
  double points_per_second;
  double bytes_per_second;
  double operations_per_second;
  double memory_share; ///< of memorySpeed ()
  double units_share;  ///< of arithmeticSpeed () with that instruction set
};

/** \brief All kernels that this processor runs, on an image of that size; best of
 * several runs. */
std::vector<KernelSpeed>
kernelSpeeds (int width, int height);

} // namespace pcl_msf::benchmarks
