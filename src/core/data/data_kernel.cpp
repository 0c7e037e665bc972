// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data/data_kernel.h"

#include "core/base/instruction_set.h"
#include "core/data/data_kernel_impl.h"

// The functions of one instruction set: `target` is the attribute that they are
// compiled with, and everything they call is inlined into them.
#define PCL_MSF_KERNEL(set, target)                                                    \
  struct set {                                                                         \
    target static void                                                                 \
    linearize (const Points& points,                                                   \
               const Image& image,                                                     \
               const Motion& motion,                                                   \
               const Rules& rules,                                                     \
               const Correspondences& state,                                           \
               Sums& sums)                                                             \
    {                                                                                  \
      run<float, Mode::Renew> (points, image, motion, rules, state, sums);             \
    }                                                                                  \
    target static void                                                                 \
    probe (const Points& points,                                                       \
           const Image& image,                                                         \
           const Motion& motion,                                                       \
           const Rules& rules,                                                         \
           Sums& sums)                                                                 \
    {                                                                                  \
      run<float, Mode::Probe> (                                                        \
          points, image, motion, rules, {nullptr, nullptr}, sums);                     \
    }                                                                                  \
    static Kernel                                                                      \
    of (InstructionSet own)                                                            \
    {                                                                                  \
      return {nameOf (own), linearize, probe};                                         \
    }                                                                                  \
  };

namespace pcl_msf {
namespace kernel {

namespace {

PCL_MSF_KERNEL (Default, )
#ifdef PCL_MSF_HAS_X86_64_LEVELS
PCL_MSF_KERNEL (X86_64_v3, PCL_MSF_X86_64_V3)
PCL_MSF_KERNEL (X86_64_v4, PCL_MSF_X86_64_V4)
#endif

Kernel
kernelFor (InstructionSet set)
{
#ifdef PCL_MSF_HAS_X86_64_LEVELS
  if (set == InstructionSet::X86_64_v4)
    return X86_64_v4::of (set);
  if (set == InstructionSet::X86_64_v3)
    return X86_64_v3::of (set);
#endif
  return Default::of (set);
}

std::vector<Kernel>
findUsable ()
{
  std::vector<Kernel> usable;
  for (const InstructionSet set : usableInstructionSets())
    usable.push_back (kernelFor (set));
  return usable;
}

} // namespace

const std::vector<Kernel>&
usableKernels ()
{
  static const std::vector<Kernel> usable = findUsable();
  return usable;
}

const Kernel&
chosenKernel ()
{
  static const Kernel chosen = kernelFor (chosenInstructionSet());
  return chosen;
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
