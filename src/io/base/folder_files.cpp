// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/folder_files.h"

#include "io/base/input_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

bool
isDigit (char c)
{
  return std::isdigit (static_cast<unsigned char> (c)) != 0;
}

/** The run of digits at a position, without leading zeros. */
std::string
digitsAt (const std::string& text, std::size_t& at)
{
  std::string digits;
  for (; at < text.size() && isDigit (text[at]); ++at)
    if (!digits.empty() || text[at] != '0')
      digits.push_back (text[at]);
  return digits;
}

} // namespace

bool
naturalLess (const std::string& a, const std::string& b)
{
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit (a[i]) && isDigit (b[j])) {
      const std::string x = digitsAt (a, i), y = digitsAt (b, j);
      if (x != y)
        return x.size() != y.size() ? x.size() < y.size() : x < y;
    }
    else if (a[i] != b[j])
      return a[i] < b[j];
    else
      ++i, ++j;
  }
  if (a.size() - i != b.size() - j)
    return a.size() - i < b.size() - j;
  return a < b;
}

std::vector<std::string>
filesIn (const std::string& folder, const std::vector<std::string>& extensions)
{
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator (folder, error)) {
    const std::string path = entry.path().string();
    const std::string extension = lowerExtension (path);
    std::error_code ignored;
    if (entry.is_regular_file (ignored) &&
        std::find (extensions.begin(), extensions.end(), extension) != extensions.end())
      files.push_back (path);
  }
  std::sort (files.begin(), files.end(), naturalLess);
  return files;
}

} // namespace pcl_msf::io
