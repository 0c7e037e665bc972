// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgcodecs.hpp>

#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/base/output_file.h"
#include "io/formats/decode_image.h"
#include "io/formats/image_codecs.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl_msf::io {

namespace {

constexpr int kNoLabel = 65535;
constexpr int kSaturated = 65535; ///< of 16-bit depth: farther than that, or nothing

[[noreturn]] void
fail (const std::string& path, const std::string& what)
{
  throw IoError (path + ": " + what);
}

/** For example "8 bit in 3 channels". */
std::string
typeText (const cv::Mat& image)
{
  const std::string kind = image.depth() >= CV_32F ? " bit float in " : " bit in ";
  return std::to_string (8 * image.elemSize1()) + kind +
         std::to_string (image.channels()) +
         (image.channels() == 1 ? " channel" : " channels");
}

void
requireType (const std::string& path, const cv::Mat& image, int type, const char* what)
{
  if (image.empty() || image.type() != type)
    fail (path, what);
}

cv::Mat
decodeDepth (const std::string& path)
{
  const std::string extension = lowerExtension (path);
  if (extension == ".dpt")
    return readDpt (path);
  if (extension == ".pfm")
    return readPfm (path);
  return decodeImage (path, cv::IMREAD_UNCHANGED, "depth");
}

} // namespace

cv::Mat
readColor (const std::string& path)
{
  cv::Mat image = decodeImage (path, cv::IMREAD_ANYCOLOR, "colour");
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3))
    fail (path,
          "colour: " + typeText (image) +
              ", not 8-bit grey or colour; convert it to an 8-bit PNG");
  return image;
}

void
readColor (const std::string& path, RgbdImages& images)
{
  const cv::Mat image = decodeImage (path, cv::IMREAD_UNCHANGED, "colour");
  if (image.type() == CV_16UC1) {
    image.convertTo (images.raw_color, CV_32F);
    unifyColors ({&images});
  }
  else if (image.type() == CV_8UC1 || image.type() == CV_8UC3)
    images.color = image;
  else
    images.color = readColor (path);
}

cv::Mat
readDepth (const std::string& path, double depth_scale, double float_scale)
{
  for (const double scale : {depth_scale, float_scale})
    if (!std::isfinite (scale) || scale <= 0.0)
      fail (path,
            "depth scale: " + generalText (scale) +
                ", must be > 0; give units per metre, for example 1000");
  const cv::Mat image = decodeDepth (path);
  if (image.type() == CV_32FC1)
    return float_scale == 1.0 ? image : cv::Mat (image / float_scale);
  if (image.type() != CV_16UC1)
    fail (path,
          "depth: " + typeText (image) +
              ", neither 16-bit integers nor 32-bit floats in one channel; give a "
              "16-bit PNG, a float TIFF, .pfm or .dpt");
  cv::Mat depth;
  image.convertTo (depth, CV_32F, 1.0 / depth_scale);
  depth.setTo (0.0F, image == kSaturated);
  return depth;
}

void
writeDepth (const std::string& path, const cv::Mat& depth, double depth_scale)
{
  requireType (path, depth, CV_32FC1, "depth: a CV_32FC1 image is needed");
  cv::Mat units (depth.size(), CV_16UC1);
  for (int row = 0; row < depth.rows; ++row)
    for (int col = 0; col < depth.cols; ++col) {
      const double value = std::round (depth.at<float> (row, col) * depth_scale);
      const bool fits = value > 0.0 && value < kSaturated;
      units.at<std::uint16_t> (row, col) =
          fits ? static_cast<std::uint16_t> (value) : std::uint16_t{0};
    }
  writeImage (path, units);
}

cv::Mat
readLabels (const std::string& path)
{
  const cv::Mat image = decodeImage (path, cv::IMREAD_UNCHANGED, "labels");
  if (image.type() != CV_8UC1 && image.type() != CV_16UC1)
    fail (path,
          "labels: " + typeText (image) +
              ", not 8 or 16 bit in one channel; give a 16-bit grey PNG");
  cv::Mat labels;
  image.convertTo (labels, CV_32S);
  if (image.depth() == CV_16U)
    labels.setTo (-1, labels == kNoLabel);
  return labels;
}

void
writeLabels (const std::string& path, const cv::Mat& labels)
{
  requireType (path, labels, CV_32SC1, "labels: a CV_32SC1 image is needed");
  double largest = 0.0;
  cv::minMaxLoc (labels, nullptr, &largest);
  if (largest >= kNoLabel)
    fail (path, "labels: more than 65535 segments do not fit; use larger ones");
  cv::Mat known = labels.clone();
  known.setTo (kNoLabel, labels < 0);
  cv::Mat image;
  known.convertTo (image, CV_16U);
  writeImage (path, image);
}

cv::Mat
readMask (const std::string& path)
{
  return decodeImage (path, cv::IMREAD_GRAYSCALE, "mask") != 0;
}

cv::Mat
readImage (const std::string& path)
{
  return decodeImage (path, cv::IMREAD_UNCHANGED, "image");
}

void
writeImage (const std::string& path, const cv::Mat& image)
{
  std::vector<unsigned char> bytes;
  try {
    bytes = encodeBytes (lowerExtension (path), image);
  }
  catch (const InvalidInput& problem) {
    fail (path, problem.what());
  }
  catch (const cv::Exception&) {
    bytes.clear();
  }
  if (bytes.empty())
    fail (path, "image: OpenCV cannot encode it in this format; use .png");
  writeBytes (path, bytes.data(), bytes.size());
}

} // namespace pcl_msf::io
