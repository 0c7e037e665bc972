// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <initializer_list>

namespace pcl_msf {

/** \brief A function's address in a shared library, which is loaded now and stays. So a
 * program that never calls the function starts without the library and without what
 * that brings along: OpenCV's image files alone bring 120 libraries, 0.1 s. Which
 * libraries are used so, `cmake/PclMsfLazyLibraries.cmake` finds out. \param files
 * names of the library, the first that is found counts \param symbol the function's
 * name in the library, mangled \throws InvalidInput when there is no such library or
 * function */
PCL_MSF_EXPORT void*
loadSymbol (std::initializer_list<const char*> files, const char* symbol);

/** \brief The same, as a pointer to a function of type F, which must be the one that
 * the library's header declares. To be kept in a static variable. */
template <typename F>
F*
loadFunction (std::initializer_list<const char*> files, const char* symbol)
{
  return reinterpret_cast<F*> (loadSymbol (files, symbol));
}

} // namespace pcl_msf
