// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/png_image.h"

#include <opencv2/imgcodecs.hpp>

#include <png.h>
#include <zlib.h>

#include <csetjmp>
#include <cstring>

namespace pcl_msf::io {

namespace {

using Bytes = std::vector<unsigned char>;

/** Bytes that libpng asks for one after the other. */
struct Source {
  const Bytes& bytes;
  std::size_t at{0};
};

void
readSome (png_structp png, png_bytep to, std::size_t count)
{
  auto* source = static_cast<Source*> (png_get_io_ptr (png));
  if (source->bytes.size() - source->at < count)
    png_error (png, "end of file");
  std::memcpy (to, source->bytes.data() + source->at, count);
  source->at += count;
}

void
writeSome (png_structp png, png_bytep from, std::size_t count)
{
  auto* bytes = static_cast<Bytes*> (png_get_io_ptr (png));
  bytes->insert (bytes->end(), from, from + count);
}

/** An error jumps back without a word. */
void
fail (png_structp png, png_const_charp)
{
  png_longjmp (png, 1);
}

void
ignore (png_structp, png_const_charp)
{}

/** What the image becomes; -1 = a kind that is left to OpenCV. */
int
typeOf (png_structp png, png_infop info, int flags)
{
  const int depth = png_get_bit_depth (png, info);
  const int color = png_get_color_type (png, info);
  const bool converts =
      flags != cv::IMREAD_UNCHANGED &&
      (depth == 16 || (flags != cv::IMREAD_ANYCOLOR && (flags != cv::IMREAD_GRAYSCALE ||
                                                        color != PNG_COLOR_TYPE_GRAY)));
  if (converts || png_get_valid (png, info, PNG_INFO_tRNS) != 0 ||
      png_get_interlace_type (png, info) != PNG_INTERLACE_NONE)
    return -1;
  if (color == PNG_COLOR_TYPE_GRAY && depth >= 8)
    return depth == 8 ? CV_8UC1 : CV_16UC1;
  return color == PNG_COLOR_TYPE_RGB && depth == 8 ? CV_8UC3 : -1;
}

/** Nothing here has a destructor that a jump would pass over. */
bool
read (png_structp png, png_infop info, int flags, cv::Mat& image)
{
  if (setjmp (png_jmpbuf (png)) != 0) // NOLINT: libpng's way to tell errors
    return false;
  png_read_info (png, info);
  const int type = typeOf (png, info, flags);
  if (type < 0)
    return false;
  image.create (static_cast<int> (png_get_image_height (png, info)),
                static_cast<int> (png_get_image_width (png, info)),
                type);
  png_set_bgr (png);
  png_set_swap (png);
  for (int y = 0; y < image.rows; ++y)
    png_read_row (png, image.ptr (y), nullptr);
  png_read_end (png, nullptr);
  return true;
}

bool
write (png_structp png, png_infop info, const cv::Mat& image)
{
  if (setjmp (png_jmpbuf (png)) != 0) // NOLINT: as above
    return false;
  png_set_filter (png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_compression_level (png, Z_BEST_SPEED);
  png_set_compression_strategy (png, Z_RLE);
  png_set_IHDR (png,
                info,
                static_cast<png_uint_32> (image.cols),
                static_cast<png_uint_32> (image.rows),
                image.depth() == CV_16U ? 16 : 8,
                image.channels() == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
                PNG_INTERLACE_NONE,
                PNG_COMPRESSION_TYPE_DEFAULT,
                PNG_FILTER_TYPE_DEFAULT);
  png_write_info (png, info);
  png_set_bgr (png);
  png_set_swap (png);
  for (int y = 0; y < image.rows; ++y)
    png_write_row (png, image.ptr (y));
  png_write_end (png, info);
  return true;
}

} // namespace

cv::Mat
decodePng (const Bytes& bytes, int flags)
{
  Source source{bytes};
  png_structp png =
      png_create_read_struct (PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png ? png_create_info_struct (png) : nullptr;
  cv::Mat image;
  if (info)
    png_set_read_fn (png, &source, readSome);
  if (!info || !read (png, info, flags, image))
    image.release();
  png_destroy_read_struct (&png, &info, nullptr);
  return image;
}

Bytes
encodePng (const cv::Mat& image)
{
  Bytes bytes;
  const int type = image.type();
  if (image.empty() || (type != CV_8UC1 && type != CV_16UC1 && type != CV_8UC3))
    return bytes;
  png_structp png =
      png_create_write_struct (PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png ? png_create_info_struct (png) : nullptr;
  if (info)
    png_set_write_fn (png, &bytes, writeSome, nullptr);
  if (!info || !write (png, info, image))
    bytes.clear();
  png_destroy_write_struct (&png, &info);
  return bytes;
}

} // namespace pcl_msf::io
