// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/config.h>

/* What the including code's compiler flags mean to it and to the library. */

// Unknown points, motions and pixels are NaN: code that takes all numbers for finite
// takes them for measurements.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "pcl_msf marks the unknown by NaN, which -ffast-math, -Ofast and \
-ffinite-math-only take away: add -fno-finite-math-only behind them."
#endif

#if EIGEN_DEFAULT_ALIGN_BYTES == 0 || EIGEN_MALLOC_ALREADY_ALIGNED
#define PCL_MSF_PLAIN_MALLOC_HERE 1
#else
#define PCL_MSF_PLAIN_MALLOC_HERE 0
#endif

/* Does this code lay out and allocate what holds Eigen's types as the library does?
 * With -march=native, -mavx and the like it does not: pcl::Registration holds matrices,
 * point clouds allocate through Eigen. Then the templates are compiled here, as for
 * types that the library has no instance of. All that is compiled in the library alone
 * neither holds nor hands over anything that depends on it. */
#if EIGEN_MAX_STATIC_ALIGN_BYTES == PCL_MSF_EIGEN_STATIC_ALIGN_BYTES &&                \
    EIGEN_DEFAULT_ALIGN_BYTES == PCL_MSF_EIGEN_HEAP_ALIGN_BYTES &&                     \
    PCL_MSF_PLAIN_MALLOC_HERE == PCL_MSF_EIGEN_PLAIN_MALLOC
#define PCL_MSF_SAME_LAYOUT 1
#else
#define PCL_MSF_SAME_LAYOUT 0
#endif
