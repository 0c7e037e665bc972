// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/decode_image.h"

#include <opencv2/imgcodecs.hpp>

#include "io/input_file.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace pcl_msf::io {

namespace {

std::uint32_t
bigEndian (const unsigned char* bytes)
{
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
         (std::uint32_t{bytes[2]} << 8) | bytes[3];
}

/** OpenCV allocates a PNG's size unseen and its decoder prints its own messages, so a
 * PNG's size and its end are looked at first. */
void
checkPng (InputFile& file, const std::string& field)
{
  constexpr std::array<unsigned char, 8> kSignature{
      0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  std::array<unsigned char, 24> head{};
  if (file.remaining() < head.size())
    file.fail (field, "too short for an image; the file is cut short");
  file.read (head.data(), head.size(), field);
  if (std::memcmp (head.data(), kSignature.data(), kSignature.size()) != 0)
    return;
  checkImageSize (
      file.path(), bigEndian (head.data() + 16), bigEndian (head.data() + 20));
  constexpr std::uint32_t kHeaderLength = 13;
  if (bigEndian (head.data() + 8) != kHeaderLength)
    file.fail (field, "the PNG's header has a wrong length; the file is damaged");
  std::uint64_t skip = kHeaderLength - 8 + 4;
  for (std::array<unsigned char, 8> chunk{}; std::memcmp (&chunk[4], "IEND", 4) != 0;) {
    if (file.remaining() < skip + chunk.size())
      file.fail (field, "the PNG has no end; the file is cut short");
    file.skip (skip);
    file.read (chunk.data(), chunk.size(), field);
    skip = bigEndian (chunk.data()) + std::uint64_t{4};
  }
}

} // namespace

cv::Mat
decodeImage (const std::string& path, int flags, const std::string& field)
{
  InputFile file (path);
  checkPng (file, field);
  cv::Mat image;
  try {
    image = cv::imread (path, flags | cv::IMREAD_IGNORE_ORIENTATION);
  }
  catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty())
    file.fail (field, "cannot be decoded; give an image that OpenCV reads, e.g. PNG");
  checkImageSize (path, image.cols, image.rows);
  return image;
}

} // namespace pcl_msf::io
