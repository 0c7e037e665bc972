// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/base/output_file.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/float_files.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace pcl_msf::io {

namespace {

/** What a portable float map says of itself. */
struct PfmHeader {
  int width{0};
  int height{0};
  int channels{0};
  bool big_endian{false};
};

int
readSide (InputFile& file, const char* field)
{
  int side = 0;
  const std::string word = file.word (field);
  if (!parseNumber (word, side))
    file.fail (field, "'" + word + "' is no number of pixels; the file is damaged");
  return side;
}

PfmHeader
readHeader (InputFile& file)
{
  PfmHeader header;
  const std::string type = file.word ("type");
  if (type != "Pf" && type != "PF")
    file.fail ("type",
               "'" + type +
                   "' is neither Pf nor PF; the file is no portable float map");
  header.channels = type == "PF" ? 3 : 1;
  header.width = readSide (file, "width");
  header.height = readSide (file, "height");
  double scale = 0.0;
  const std::string word = file.word ("scale");
  if (!parseNumber (word, scale) || scale == 0.0)
    file.fail (
        "scale",
        "'" + word +
            "' is no scale, whose sign gives the byte order; the file is damaged");
  header.big_endian = scale > 0.0;
  checkImageSize (file.path(), header.width, header.height);
  return header;
}

void
swapBytes (unsigned char* words, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
    std::reverse (words + 4 * i, words + 4 * i + 4);
}

} // namespace

cv::Mat
readPfm (const std::string& path)
{
  InputFile file (path);
  const PfmHeader header = readHeader (file);
  const std::size_t row_bytes = std::size_t{4} * header.width * header.channels;
  if (file.remaining() < row_bytes * header.height)
    file.fail ("pixels", "the file ends too early; it is cut short");
  cv::Mat image (header.height, header.width, CV_32FC (header.channels));
  for (int row = image.rows - 1; row >= 0; --row) {
    file.read (image.ptr (row), row_bytes, "pixels");
    if (header.big_endian)
      swapBytes (image.ptr (row), row_bytes / 4);
  }
  return image;
}

void
writePfm (const std::string& path, const cv::Mat& image)
{
  if ((image.type() != CV_32FC1 && image.type() != CV_32FC3) || image.empty())
    throw IoError (path + ": image: a CV_32FC1 or CV_32FC3 image is needed");
  std::string bytes = image.channels() == 3 ? "PF\n" : "Pf\n";
  bytes += std::to_string (image.cols) + " " + std::to_string (image.rows) + "\n-1\n";
  const std::size_t row_bytes = image.cols * image.elemSize();
  bytes.reserve (bytes.size() + image.rows * row_bytes);
  for (int row = image.rows - 1; row >= 0; --row)
    bytes.append (image.ptr<char> (row), row_bytes);
  writeBytes (path, bytes.data(), bytes.size());
}

} // namespace pcl_msf::io
