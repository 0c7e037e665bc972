// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <cstddef>
#include <functional>
#include <string>

namespace pcl_msf::io {

/** \brief Has a file written under a temporary name in the same folder and renames it,
 * so that a half-written file never stands under the final name.
 *
 * \param path final name \param write writes the whole file to the name that it is
 * given \throws IoError when it cannot be written; the temporary file is removed */
PCL_MSF_EXPORT void
writeThenRename (const std::string& path,
                 const std::function<void (const std::string&)>& write);

/** \brief Writes one block of bytes that way. */
PCL_MSF_EXPORT void
writeBytes (const std::string& path, const void* bytes, std::size_t size);

} // namespace pcl_msf::io
