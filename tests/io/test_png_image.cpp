// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgcodecs.hpp>

#include "io/formats/image_codecs.h"
#include "support/temporary_folder.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>

#ifdef PCL_MSF_HAS_PNG
#include "io/formats/png_image.h"
#endif

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

/** Values of the whole range, of an odd size. */
cv::Mat
picture (int type)
{
  cv::Mat image (33, 57, type);
  cv::RNG random (7);
  random.fill (image, cv::RNG::UNIFORM, 0, image.depth() == CV_16U ? 65536 : 256);
  return image;
}

std::vector<unsigned char>
pngByOpenCv (const cv::Mat& image)
{
  std::vector<unsigned char> bytes;
  EXPECT_TRUE (cv::imencode (".png", image, bytes));
  return bytes;
}

/** Not even in their types or in one value. */
void
expectSame (const cv::Mat& image, const cv::Mat& expected, const std::string& what)
{
  ASSERT_EQ (image.type(), expected.type()) << what;
  ASSERT_EQ (image.size(), expected.size()) << what;
  EXPECT_EQ (cv::norm (image, expected, cv::NORM_INF), 0.0) << what;
}

const std::vector<int> kFlags{cv::IMREAD_UNCHANGED,
                              cv::IMREAD_ANYCOLOR,
                              cv::IMREAD_GRAYSCALE,
                              cv::IMREAD_COLOR,
                              cv::IMREAD_ANYDEPTH | cv::IMREAD_ANYCOLOR};

TEST (ImageCodecs, DecodeAsOpenCvDoesWhateverIsAsked)
{
  for (const int type : {CV_8UC1, CV_16UC1, CV_8UC3, CV_8UC4, CV_16UC3, CV_16UC4}) {
    const auto bytes = pngByOpenCv (picture (type));
    for (const int flags : kFlags)
      expectSame (io::decodeBytes (bytes, flags),
                  cv::imdecode (bytes, flags),
                  std::to_string (type) + " with " + std::to_string (flags));
  }
}

TEST (ImageCodecs, EncodeWhatOpenCvReadsBack)
{
  for (const int type : {CV_8UC1, CV_16UC1, CV_8UC3, CV_8UC4, CV_16UC3}) {
    const cv::Mat image = picture (type);
    const auto bytes = io::encodeBytes (".png", image);
    expectSame (cv::imdecode (bytes, cv::IMREAD_UNCHANGED), image, "type");
    EXPECT_EQ (bytes, pngByOpenCv (image)) << "neither larger nor other files";
  }
  const cv::Mat part = picture (CV_8UC3) (cv::Rect (3, 4, 20, 10));
  expectSame (cv::imdecode (io::encodeBytes (".png", part), cv::IMREAD_UNCHANGED),
              part,
              "rows that are not one after the other");
}

TEST (ImageCodecs, OtherFormatsGoThroughOpenCv)
{
  const cv::Mat image = picture (CV_8UC3);
  for (const char* extension : {".bmp", ".tiff", ".ppm"})
    expectSame (
        io::decodeBytes (io::encodeBytes (extension, image), cv::IMREAD_UNCHANGED),
        image,
        extension);
  EXPECT_FALSE (io::encodeBytes (".jpg", image).empty());
  EXPECT_TRUE (io::encodeBytes (".png", cv::Mat()).empty());
}

#ifdef PCL_MSF_HAS_PNG

TEST (PngImage, TakesWhatDepthLabelsAndColourComeIn)
{
  for (const int type : {CV_8UC1, CV_16UC1, CV_8UC3}) {
    const cv::Mat image = picture (type);
    expectSame (io::decodePng (pngByOpenCv (image), cv::IMREAD_UNCHANGED),
                image,
                std::to_string (type));
  }
}

TEST (PngImage, LeavesOtherKindsAndConversions)
{
  for (const int type : {CV_8UC4, CV_16UC3})
    EXPECT_TRUE (
        io::decodePng (pngByOpenCv (picture (type)), cv::IMREAD_UNCHANGED).empty())
        << type;
  EXPECT_TRUE (
      io::decodePng (pngByOpenCv (picture (CV_8UC3)), cv::IMREAD_GRAYSCALE).empty());
  EXPECT_TRUE (
      io::decodePng (pngByOpenCv (picture (CV_16UC1)), cv::IMREAD_ANYCOLOR).empty());
  EXPECT_TRUE (io::encodePng (picture (CV_8UC4)).empty());
}

TEST (PngImage, GivesNothingForDamagedBytes)
{
  const auto whole = pngByOpenCv (picture (CV_16UC1));
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    const std::vector<unsigned char> cut (whole.begin(), whole.begin() + size);
    EXPECT_TRUE (io::decodePng (cut, cv::IMREAD_UNCHANGED).empty()) << size;
  }
  for (std::size_t at = 8; at < 60; ++at) {
    auto changed = whole;
    changed[at] ^= 0xFF;
    io::decodePng (changed, cv::IMREAD_UNCHANGED); // whatever it gives, it returns
  }
  EXPECT_TRUE (io::decodePng ({}, cv::IMREAD_UNCHANGED).empty());
}

#endif

} // namespace
