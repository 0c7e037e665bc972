// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/config.h>

// The version, as PCL has its own: numbers for the preprocessor and one for people.

#define PCL_MSF_VERSION_NUMBER(major, minor, patch)                                    \
  ((major)*100000 + (minor)*100 + (patch))

/** \brief Of this library, for example 100 for 0.1.0. */
#define PCL_MSF_VERSION                                                                \
  PCL_MSF_VERSION_NUMBER (                                                             \
      PCL_MSF_VERSION_MAJOR, PCL_MSF_VERSION_MINOR, PCL_MSF_VERSION_PATCH)

/** \brief Compares it, \code #if PCL_MSF_VERSION_COMPARE (>=, 0, 2, 0) \endcode */
#define PCL_MSF_VERSION_COMPARE(op, major, minor, patch)                               \
  (PCL_MSF_VERSION op PCL_MSF_VERSION_NUMBER (major, minor, patch))

#define PCL_MSF_VERSION_TEXT_(major, minor, patch) #major "." #minor "." #patch
#define PCL_MSF_VERSION_TEXT(major, minor, patch)                                      \
  PCL_MSF_VERSION_TEXT_ (major, minor, patch)

/** \brief "0.1.0" */
#define PCL_MSF_VERSION_PRETTY                                                         \
  PCL_MSF_VERSION_TEXT (                                                               \
      PCL_MSF_VERSION_MAJOR, PCL_MSF_VERSION_MINOR, PCL_MSF_VERSION_PATCH)
