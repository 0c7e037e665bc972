// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

/** \brief Has a function take in all that it calls, so that none of Eigen's functions
 * for aligned types is left as a symbol that users' code could share (see ABI in
 * ARCHITECTURE.md).
 *
 * Under a sanitizer it does nothing: there every access is checked, and a compiler
 * works for half an hour on such a function. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) ||                   \
    defined(__SANITIZE_UNDEFINED__)
#define PCL_MSF_FLATTEN
#else
#define PCL_MSF_FLATTEN [[gnu::flatten]]
#endif
