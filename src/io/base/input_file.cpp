// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/input_file.h"

#include <pcl_msf/errors.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <string_view>

namespace pcl_msf::io {

namespace {

constexpr std::int64_t kMaxSide = 32768;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;

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

std::optional<std::string>
InputFile::filledLine()
{
  std::string result;
  bool filled = false;
  for (int c = stream_.get(); c != EOF && !(c == '\n' && filled); c = stream_.get()) {
    if (c == '\n')
      result.clear();
    else
      result.push_back (static_cast<char> (c));
    filled = filled || !std::isspace (c);
  }
  return filled ? std::optional (result) : std::nullopt;
}

void
InputFile::skipByteOrderMark()
{
  const auto begin = stream_.tellg();
  std::array<char, 3> mark{};
  stream_.read (mark.data(), mark.size());
  const std::string_view read (mark.data(),
                               static_cast<std::size_t> (stream_.gcount()));
  stream_.clear();
  if (read.substr (0, 2) == "\xFF\xFE" || read.substr (0, 2) == "\xFE\xFF")
    fail ("encoding", "the text is in UTF-16; save it as UTF-8");
  if (read != "\xEF\xBB\xBF")
    stream_.seekg (begin);
}

std::string
InputFile::text (std::uint64_t most)
{
  if (remaining() > most)
    fail ("size",
          std::to_string (remaining()) + " bytes, and up to " + std::to_string (most) +
              " are read; it is no text file of this kind");
  skipByteOrderMark();
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
lowerCase (std::string text)
{
  for (char& c : text)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char> (c - 'A' + 'a');
  return text;
}

std::string
lowerExtension (const std::string& path)
{
  return lowerCase (std::filesystem::path (path).extension().string());
}

} // namespace pcl_msf::io
