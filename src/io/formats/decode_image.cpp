// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/decode_image.h"

#include <boost/crc.hpp>

#include "io/base/input_file.h"
#include "io/formats/image_codecs.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl_msf::io {

namespace {

using Bytes = std::vector<unsigned char>;

constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 30;

std::uint32_t
bigEndian (const unsigned char* bytes)
{
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
         (std::uint32_t{bytes[2]} << 8) | bytes[3];
}

bool
isPng (const Bytes& bytes)
{
  constexpr std::array<unsigned char, 8> kSignature{
      0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return bytes.size() >= kSignature.size() &&
         std::memcmp (bytes.data(), kSignature.data(), kSignature.size()) == 0;
}

/** OpenCV allocates a PNG's size unseen, and its decoder prints messages of its own
 * about damage; so size, chunks and their checksums are looked at before. */
void
checkPng (const InputFile& file, const Bytes& bytes, const std::string& field)
{
  constexpr std::size_t kAround = 12; // length, type and checksum of a chunk
  bool ended = false;
  for (std::size_t at = 8; !ended;) {
    if (bytes.size() < at + kAround)
      file.fail (field, "the PNG has no end; the file is cut short");
    const std::size_t length = bigEndian (&bytes[at]);
    if (bytes.size() - at - kAround < length)
      file.fail (field, "a chunk of the PNG is too long; the file is cut short");
    boost::crc_32_type checksum;
    checksum.process_bytes (&bytes[at + 4], length + 4);
    if (checksum.checksum() != bigEndian (&bytes[at + 8 + length]))
      file.fail (field, "a checksum of the PNG is wrong; the file is damaged");
    if (at == 8 && length >= 8)
      checkImageSize (
          file.path(), bigEndian (&bytes[at + 8]), bigEndian (&bytes[at + 12]));
    ended = std::memcmp (&bytes[at + 4], "IEND", 4) == 0;
    at += kAround + length;
  }
}

bool
isJpeg (const Bytes& bytes)
{
  return bytes.size() > 3 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
}

/** The decoder fills what is missing with grey. */
void
checkJpeg (const InputFile& file, const Bytes& bytes, const std::string& field)
{
  constexpr std::array<unsigned char, 2> kEnd{0xFF, 0xD9};
  if (std::search (bytes.begin(), bytes.end(), kEnd.begin(), kEnd.end()) == bytes.end())
    file.fail (field, "the JPEG has no end; the file is cut short");
}

} // namespace

cv::Mat
decodeImage (const std::string& path, int flags, const std::string& field)
{
  InputFile file (path);
  if (file.remaining() == 0 || file.remaining() > kLargestFile)
    file.fail (field,
               std::to_string (file.remaining()) +
                   " bytes, and 1 to 2^30 are read; give an image");
  Bytes bytes (file.remaining());
  file.read (bytes.data(), bytes.size(), field);
  if (isPng (bytes))
    checkPng (file, bytes, field);
  if (isJpeg (bytes))
    checkJpeg (file, bytes, field);
  cv::Mat image;
  try {
    image = decodeBytes (bytes, flags);
  }
  catch (const InvalidInput& problem) {
    file.fail (field, problem.what());
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
