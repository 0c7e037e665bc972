// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/instruction_set.h"

#include <pcl/console/print.h>

#include <cstdlib>
#include <string>

namespace pcl_msf {

namespace {

std::vector<InstructionSet>
findUsable ()
{
  std::vector<InstructionSet> usable;
#ifdef PCL_MSF_HAS_X86_64_LEVELS
  if (__builtin_cpu_supports ("x86-64-v4"))
    usable.push_back (InstructionSet::X86_64_v4);
  if (__builtin_cpu_supports ("x86-64-v3"))
    usable.push_back (InstructionSet::X86_64_v3);
#endif
  usable.push_back (InstructionSet::Default);
  return usable;
}

InstructionSet
choose ()
{
  const std::vector<InstructionSet>& usable = usableInstructionSets();
  const char* wanted = std::getenv ("PCL_MSF_ISA");
  if (wanted == nullptr)
    return usable.front();
  std::string names;
  for (const InstructionSet set : usable) {
    if (nameOf (set) == std::string (wanted))
      return set;
    names += std::string (" ") + nameOf (set);
  }
  PCL_WARN (
      "[pcl_msf] PCL_MSF_ISA=%s is none of this processor's:%s; the first of them "
      "is used.\n",
      wanted,
      names.c_str());
  return usable.front();
}

} // namespace

const char*
nameOf (InstructionSet set)
{
  switch (set) {
  case InstructionSet::X86_64_v4:
    return "x86-64-v4";
  case InstructionSet::X86_64_v3:
    return "x86-64-v3";
  default:
    return "default";
  }
}

const std::vector<InstructionSet>&
usableInstructionSets ()
{
  static const std::vector<InstructionSet> usable = findUsable();
  return usable;
}

InstructionSet
chosenInstructionSet ()
{
  static const InstructionSet chosen = choose();
  return chosen;
}

} // namespace pcl_msf
