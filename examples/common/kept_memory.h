// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl_msf::tool {

/** \brief Has the process keep what it frees: for programs that need the same images
 * for each frame again, which the system would hand out page by page. */
inline void
keepFreedMemory ()
{
#ifdef __GLIBC__
  constexpr int most = 1 << 25; // bytes, as glibc allows at the most
  mallopt (M_MMAP_THRESHOLD, most);
  mallopt (M_TRIM_THRESHOLD, most);
#endif
}

} // namespace pcl_msf::tool
