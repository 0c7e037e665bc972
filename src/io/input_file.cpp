// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/input_file.h"

#include <pcl_msf/errors.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>

namespace pcl_msf::io {

namespace {

constexpr std::int64_t kMaxSide = 32768;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;
constexpr std::uint64_t kMaxText = std::uint64_t{1} << 20;

} // namespace

InputFile::InputFile (const std::string& path) : path_ (path)
{
  std::error_code error;
  const auto status = std::filesystem::status (path, error);
  if (!std::filesystem::exists (status))
    throw IoError (path + ": no such file; check the path");
  if (!std::filesystem::is_regular_file (status))
    throw IoError (path + ": not a file; give the path of a file");
  size_ = std::filesystem::file_size (path, error);
  stream_.open (path, std::ios::binary);
  if (error || !stream_)
    throw IoError (path + ": cannot be opened; check its permissions");
}

std::uint64_t
InputFile::remaining()
{
  const auto position = stream_.tellg();
  const auto read = static_cast<std::uint64_t> (std::max<std::int64_t> (0, position));
  return read < size_ ? size_ - read : 0;
}

void
InputFile::read (void* to, std::uint64_t bytes, const std::string& field)
{
  stream_.read (static_cast<char*> (to), static_cast<std::streamsize> (bytes));
  if (static_cast<std::uint64_t> (stream_.gcount()) != bytes)
    fail (field, "the file ends too early; it is cut short or of another format");
}

std::string
InputFile::word (const std::string& field)
{
  std::string result;
  for (int c = stream_.get(); c != EOF && result.size() <= 64; c = stream_.get()) {
    if (!std::isspace (c))
      result.push_back (static_cast<char> (c));
    else if (!result.empty())
      return result;
  }
  fail (field, "no such word in the header; the file is of another format");
}

std::string
InputFile::line (const std::string& field)
{
  std::string result;
  for (int c = stream_.get(); c != EOF && result.size() <= 65536; c = stream_.get()) {
    if (c == '\n')
      return result;
    result.push_back (static_cast<char> (c));
  }
  fail (field,
        "ends before it is complete; the file is cut short or of another format");
}

std::string
InputFile::text()
{
  if (remaining() > kMaxText)
    fail ("size", "longer than 1 MB; it is no text file of this kind");
  return {std::istreambuf_iterator<char> (stream_), {}};
}

void
InputFile::fail (const std::string& field, const std::string& problem) const
{
  throw IoError (path_ + ": " + field + ": " + problem);
}

void
checkImageSize (const std::string& path, std::int64_t width, std::int64_t height)
{
  const bool sane = width > 0 && height > 0 && width <= kMaxSide &&
                    height <= kMaxSide && width * height <= kMaxPixels;
  if (!sane)
    throw IoError (path + ": width, height: " + std::to_string (width) + " x " +
                   std::to_string (height) +
                   " is no image size (up to 67 million pixels are read); the file is "
                   "damaged or of another format");
}

std::string
lowerExtension (const std::string& path)
{
  std::string extension = std::filesystem::path (path).extension().string();
  std::transform (
      extension.begin(), extension.end(), extension.begin(), [] (unsigned char c) {
        return static_cast<char> (std::tolower (c));
      });
  return extension;
}

} // namespace pcl_msf::io
