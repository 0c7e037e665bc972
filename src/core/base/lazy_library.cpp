// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/lazy_library.h"

#include <dlfcn.h>
#include <pcl_msf/errors.h>

#include <string>

namespace pcl_msf {

namespace {

std::string
problem ()
{
  const char* text = ::dlerror();
  return text ? text : "unknown problem";
}

} // namespace

void*
loadSymbol (std::initializer_list<const char*> files, const char* symbol)
{
  std::string problems;
  for (const char* file : files) {
    void* library = ::dlopen (file, RTLD_LAZY | RTLD_LOCAL);
    void* address = library ? ::dlsym (library, symbol) : nullptr;
    if (address)
      return address;
    problems += (problems.empty() ? "" : "; ") + problem();
  }
  throw InvalidInput ("a library that is needed now cannot be loaded (" + problems +
                      "): install it again, as it was when pcl_msf was built");
}

} // namespace pcl_msf
