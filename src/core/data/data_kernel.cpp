// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data/data_kernel.h"

#include <pcl/console/print.h>

#include "core/data/data_kernel_impl.h"

#include <cstdlib>
#include <string>

// The functions of one instruction set: `target` is the attribute that they are
// compiled with, and everything they call is inlined into them. Chosen by a table and
// not by target_clones, so that tests and sanitizers can run each of them.
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
    named (const char* name)                                                           \
    {                                                                                  \
      return {name, linearize, probe};                                                 \
    }                                                                                  \
  };

namespace pcl_msf {
namespace kernel {

namespace {

PCL_MSF_KERNEL (Default, )
#ifdef PCL_MSF_HAS_X86_64_LEVELS
PCL_MSF_KERNEL (X86_64_v3, __attribute__ ((target ("arch=x86-64-v3"))))
PCL_MSF_KERNEL (X86_64_v4, __attribute__ ((target ("arch=x86-64-v4"))))
#endif

std::vector<Kernel>
findUsable ()
{
  std::vector<Kernel> usable;
#ifdef PCL_MSF_HAS_X86_64_LEVELS
  if (__builtin_cpu_supports ("x86-64-v4"))
    usable.push_back (X86_64_v4::named ("x86-64-v4"));
  if (__builtin_cpu_supports ("x86-64-v3"))
    usable.push_back (X86_64_v3::named ("x86-64-v3"));
#endif
  usable.push_back (Default::named ("default"));
  return usable;
}

Kernel
choose ()
{
  const char* wanted = std::getenv ("PCL_MSF_ISA");
  if (wanted == nullptr)
    return usableKernels().front();
  std::string names;
  for (const Kernel& kernel : usableKernels()) {
    if (kernel.name == std::string (wanted))
      return kernel;
    names += std::string (" ") + kernel.name;
  }
  PCL_WARN (
      "[pcl_msf] PCL_MSF_ISA=%s is none of this processor's:%s; the first of them "
      "is used.\n",
      wanted,
      names.c_str());
  return usableKernels().front();
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
  static const Kernel chosen = choose();
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
