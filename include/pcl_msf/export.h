// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

/** \brief What a shared library of pcl_msf shows to the code that it is linked to; all
 * else is hidden in it. One macro serves all of the libraries: where they can be built
 * shared, nothing is imported differently from how it is exported. */
#if defined(__GNUC__)
#define PCL_MSF_EXPORT __attribute__ ((visibility ("default")))
#else
#define PCL_MSF_EXPORT
#endif
