// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "io/base/folder_files.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief Of colour images, in small letters with the dot; the first of them counts. */
inline const std::vector<std::string> kColorExtensions{
    ".png", ".jpg", ".jpeg", ".ppm", ".pgm", ".bmp", ".tiff", ".tif", ".webp"};

/** \brief `folder`/`name`. */
std::string
inside (const std::string& folder, const std::string& name);

bool
isFolder (const std::string& path);

bool
isFile (const std::string& path);

/** \brief The last part of a path, also of "a/b/". */
std::string
lastName (const std::string& path);

/** \brief The path without its last part, also of "a/b/". */
std::string
parentFolder (const std::string& path);

/** \brief `number` with leading zeros. */
std::string
padded (int number, int digits);

/** \brief The number at the end of a file's name before its extension; -1 without. */
int
trailingNumber (const std::string& path);

/** \brief Names of the folders in a folder, in natural order. */
std::vector<std::string>
foldersIn (const std::string& folder);

/** \brief `path` itself or else the folders below it that satisfy a predicate, in
 * natural order; below such a one no more are looked for, nor deeper than six. */
std::vector<std::string>
foldersWhere (const std::string& path,
              const std::function<bool (const std::string&)>& predicate);

/** \brief What to call the sequence of a folder: its path below `top`, or its own name
 * when it is `top` itself. */
std::string
nameBelow (const std::string& top, const std::string& folder);

} // namespace pcl_msf::io
