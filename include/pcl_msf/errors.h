// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <stdexcept>
#include <string>

namespace pcl_msf {

/** \brief Input that the method cannot work on; what() names the input and the remedy.
 *
 * Thrown by the image-level core and the io library. The PCL class catches it, prints
 * it with PCL_ERROR and reports `hasConverged () == false`.
 */
class PCL_MSF_EXPORT InvalidInput : public std::invalid_argument {
public:
  using std::invalid_argument::invalid_argument;
};

/** \brief A file that cannot be read or written; what() names the file, the field and
 * the remedy. Thrown by the io library only. */
class PCL_MSF_EXPORT IoError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace pcl_msf
