// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/file_lists.h"

#include "core/base/number_text.h"
#include "io/base/input_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 6;

fs::path
withoutSlash (const std::string& path)
{
  const fs::path clean = fs::path (path).lexically_normal();
  return clean.has_filename() ? clean : clean.parent_path();
}

/** Not a recording: hidden, or results that the project's tool has written there. */
bool
isNoRecording (const std::string& path)
{
  return lastName (path).front() == '.' ||
         isFile (inside (path, ".pcl_msf_scene_flow"));
}

void
collect (const std::string& path,
         const std::function<bool (const std::string&)>& predicate,
         int deeper,
         std::vector<std::string>& found)
{
  if (predicate (path)) {
    found.push_back (path);
    return;
  }
  if (deeper == 0)
    return;
  for (const std::string& name : foldersIn (path))
    if (!isNoRecording (inside (path, name)))
      collect (inside (path, name), predicate, deeper - 1, found);
}

} // namespace

std::string
inside (const std::string& folder, const std::string& name)
{
  return (fs::path (folder) / name).string();
}

bool
isFolder (const std::string& path)
{
  std::error_code ignored;
  return fs::is_directory (path, ignored);
}

bool
isFile (const std::string& path)
{
  std::error_code ignored;
  return fs::is_regular_file (path, ignored);
}

std::string
lastName (const std::string& path)
{
  std::error_code ignored;
  return withoutSlash (fs::absolute (path, ignored).string()).filename().string();
}

std::string
parentFolder (const std::string& path)
{
  const std::string parent = withoutSlash (path).parent_path().string();
  return parent.empty() ? "." : parent;
}

std::string
padded (int number, int digits)
{
  const std::string text = std::to_string (number);
  const auto missing = std::max<int> (0, digits - static_cast<int> (text.size()));
  return std::string (static_cast<std::size_t> (missing), '0') + text;
}

int
trailingNumber (const std::string& path)
{
  const std::string stem = fs::path (path).stem().string();
  std::size_t begin = stem.size();
  while (begin > 0 && std::isdigit (static_cast<unsigned char> (stem[begin - 1])) != 0)
    --begin;
  int number = -1;
  return parseNumber (std::string_view (stem).substr (begin), number) ? number : -1;
}

std::vector<std::string>
foldersIn (const std::string& folder)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator (folder, error))
    if (isFolder (entry.path().string()))
      names.push_back (entry.path().filename().string());
  std::sort (names.begin(), names.end(), naturalLess);
  return names;
}

std::vector<std::string>
foldersWhere (const std::string& path,
              const std::function<bool (const std::string&)>& predicate)
{
  std::vector<std::string> found;
  collect (path, predicate, kDeepest, found);
  return found;
}

std::string
nameBelow (const std::string& top, const std::string& folder)
{
  const fs::path relative =
      withoutSlash (folder).lexically_relative (withoutSlash (top));
  if (relative.empty() || relative == ".")
    return lastName (folder);
  return relative.generic_string();
}

} // namespace pcl_msf::io
