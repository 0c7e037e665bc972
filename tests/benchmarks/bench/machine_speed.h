// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <string>

namespace pcl_msf::benchmarks {

/** \brief Bytes a second that one core moves between memory and itself: the best of
 * several passes a = b + s c over arrays that no cache holds. */
double
memorySpeed ();

/** \brief Operations a second that one core's units do in float with an instruction set
 * of kernel::usableKernels (): the best of several runs of independent a = a m + c. */
double
arithmeticSpeed (const std::string& instruction_set);

/** \brief As /proc/cpuinfo names it; "unknown processor" elsewhere. */
std::string
processorName ();

} // namespace pcl_msf::benchmarks
