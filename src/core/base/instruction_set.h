// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <vector>

// Functions that are compiled for several instruction sets. Chosen by a table and not
// by target_clones, so that tests and sanitizers can run each of them. They take no
// Eigen types, whose layout would depend on the set.

#ifdef PCL_MSF_HAS_X86_64_LEVELS
#define PCL_MSF_X86_64_V3 __attribute__ ((target ("arch=x86-64-v3")))
#define PCL_MSF_X86_64_V4 __attribute__ ((target ("arch=x86-64-v4")))
#endif

namespace pcl_msf {

enum class InstructionSet { Default, X86_64_v3, X86_64_v4 };

/** \brief As PCL_MSF_ISA calls it. */
PCL_MSF_EXPORT const char*
nameOf (InstructionSet set);

/** \brief What this processor runs, the fastest first; the last one, Default, always
 * is. */
PCL_MSF_EXPORT const std::vector<InstructionSet>&
usableInstructionSets ();

/** \brief The one that is used: that which the environment variable PCL_MSF_ISA names
 * at the first call in the process, otherwise the fastest. */
PCL_MSF_EXPORT InstructionSet
chosenInstructionSet ();

} // namespace pcl_msf

// Defines `function (input, set)`, which runs `body (input)` compiled for a set. The
// body is a function that is always inlined, with all that it calls.
#ifdef PCL_MSF_HAS_X86_64_LEVELS
#define PCL_MSF_VERSIONS(function, body, Input)                                        \
  PCL_MSF_X86_64_V3 void function##_v3 (const Input& input) { body (input); }          \
  PCL_MSF_X86_64_V4 void function##_v4 (const Input& input) { body (input); }          \
  void function##_plain (const Input& input) { body (input); }                         \
  void function (const Input& input, InstructionSet set)                               \
  {                                                                                    \
    if (set == InstructionSet::X86_64_v4)                                              \
      function##_v4 (input);                                                           \
    else if (set == InstructionSet::X86_64_v3)                                         \
      function##_v3 (input);                                                           \
    else                                                                               \
      function##_plain (input);                                                        \
  }
#else
#define PCL_MSF_VERSIONS(function, body, Input)                                        \
  void function (const Input& input, InstructionSet) { body (input); }
#endif
