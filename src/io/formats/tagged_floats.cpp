// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/tagged_floats.h"

#include "io/base/input_file.h"
#include "io/base/output_file.h"

#include <cstdint>
#include <cstring>
#include <vector>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "the file readers are written for little-endian machines"
#endif

namespace pcl_msf::io {

namespace {

/** The file after its head, which fits the file. */
InputFile
openTaggedFloats (const std::string& path, int channels, cv::Size& size)
{
  InputFile file (path);
  if (file.value<float> ("magic number") != kFloatTag)
    file.fail ("magic number", "not 202021.25; the file is of another format");
  size.width = file.value<std::int32_t> ("width");
  size.height = file.value<std::int32_t> ("height");
  checkImageSize (path, size.width, size.height);
  const std::uint64_t bytes = std::uint64_t{4} * size.width * size.height * channels;
  if (file.remaining() != bytes)
    file.fail ("pixels",
               std::to_string (file.remaining()) + " bytes where " +
                   std::to_string (bytes) + " belong; the file is damaged");
  return file;
}

} // namespace

void
checkTaggedFloats (const std::string& path, int channels)
{
  cv::Size size;
  openTaggedFloats (path, channels, size);
}

cv::Mat
readTaggedFloats (const std::string& path, int channels)
{
  cv::Size size;
  InputFile file = openTaggedFloats (path, channels, size);
  cv::Mat image (size, CV_32FC (channels));
  file.read (image.data, file.remaining(), "pixels");
  return image;
}

void
writeTaggedFloats (const std::string& path, const cv::Mat& image)
{
  const std::int32_t size[2] = {image.cols, image.rows};
  const std::size_t row_bytes = image.cols * image.elemSize();
  std::vector<unsigned char> bytes (12 + image.rows * row_bytes);
  std::memcpy (bytes.data(), &kFloatTag, 4);
  std::memcpy (bytes.data() + 4, size, 8);
  for (int row = 0; row < image.rows; ++row)
    std::memcpy (bytes.data() + 12 + row * row_bytes, image.ptr (row), row_bytes);
  writeBytes (path, bytes.data(), bytes.size());
}

} // namespace pcl_msf::io
