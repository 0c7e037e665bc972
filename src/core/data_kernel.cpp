// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data_kernel.h"

#include "core/data_kernel_impl.h"

// Compiled for several instruction sets, chosen at run time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                 \
    !defined(__SANITIZE_ADDRESS__)
#define PCL_MSF_CLONES                                                                 \
  __attribute__ ((target_clones ("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PCL_MSF_CLONES
#endif

namespace pcl_msf {
namespace kernel {

PCL_MSF_CLONES void
linearize (const Points& points,
           const Image& image,
           const Motion& motion,
           const Rules& rules,
           const Correspondences& state,
           Sums& sums)
{
  run<float, Mode::Renew> (points, image, motion, rules, state, sums);
}

PCL_MSF_CLONES void
linearizeKept (const Points& points,
               const Image& image,
               const Motion& motion,
               const Rules& rules,
               const Correspondences& state,
               Sums& sums)
{
  run<float, Mode::Keep> (points, image, motion, rules, state, sums);
}

PCL_MSF_CLONES void
cost (const Points& points,
      const Image& image,
      const Motion& motion,
      const Rules& rules,
      const Correspondences& state,
      Sums& sums)
{
  run<float, Mode::Cost> (points, image, motion, rules, state, sums);
}

PCL_MSF_CLONES void
probe (const Points& points,
       const Image& image,
       const Motion& motion,
       const Rules& rules,
       Sums& sums)
{
  run<float, Mode::Probe> (points, image, motion, rules, {nullptr, nullptr}, sums);
}

void
linearizeKeptInDouble (const Points& points,
                       const Image& image,
                       const Motion& motion,
                       const Rules& rules,
                       const Correspondences& state,
                       Sums& sums)
{
  run<double, Mode::Keep> (points, image, motion, rules, state, sums);
}

} // namespace kernel
} // namespace pcl_msf
