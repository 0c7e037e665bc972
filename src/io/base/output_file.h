// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <cstddef>
#include <functional>
#include <string>

namespace pcl_msf::io {

/** \brief Has a file written under a temporary name in the same folder, hidden and with
 * the same extension, and renames it, so that a half-written file never stands under
 * the final name. Temporary files in that folder whose writers were killed are removed.
 *
 * \param path final name; of a link, the file that it leads to is replaced
 * \param write writes the whole file to the name that it is given, where an empty one
 * is \throws IoError when it cannot be written, also when what is there is a folder, a
 * device or a pipe; the temporary file is removed */
PCL_MSF_EXPORT void
writeThenRename (const std::string& path,
                 const std::function<void (const std::string&)>& write);

/** \brief Writes one block of bytes that way. */
PCL_MSF_EXPORT void
writeBytes (const std::string& path, const void* bytes, std::size_t size);

} // namespace pcl_msf::io
