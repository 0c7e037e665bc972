// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/cloud_colors.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstring>

namespace pcl_msf::io {

namespace {

/** Calls f (row, col, bytes of the point) for every point. */
template <typename Function>
void
forEachPoint (const pcl::PCLPointCloud2& cloud, const Function& f)
{
  const unsigned char* bytes = cloud.data.data();
  for (int row = 0; row < static_cast<int> (cloud.height); ++row)
    for (int col = 0; col < static_cast<int> (cloud.width); ++col) {
      f (row, col, bytes);
      bytes += cloud.point_step;
    }
}

cv::Mat
unpacked (const pcl::PCLPointCloud2& cloud, const CloudChannel& packed)
{
  cv::Mat color (
      static_cast<int> (cloud.height), static_cast<int> (cloud.width), CV_8UC3);
  forEachPoint (cloud, [&] (int row, int col, const unsigned char* bytes) {
    std::uint32_t argb = 0;
    std::memcpy (&argb, bytes + packed.offset, sizeof (argb));
    const auto byte = [argb] (unsigned bit) {
      return static_cast<unsigned char> (argb >> bit);
    };
    color.at<cv::Vec3b> (row, col) = {byte (0), byte (8), byte (16)};
  });
  return color;
}

/** As they are in the file; what is not finite counts as black. */
cv::Mat
numbersOf (const pcl::PCLPointCloud2& cloud, const std::vector<CloudChannel>& channels)
{
  const auto count = static_cast<int> (channels.size());
  cv::Mat raw (static_cast<int> (cloud.height),
               static_cast<int> (cloud.width),
               CV_MAKETYPE (CV_32F, count));
  forEachPoint (cloud, [&] (int row, int col, const unsigned char* bytes) {
    for (int i = 0; i < count; ++i) {
      const double value = channels[static_cast<std::size_t> (i)].value (bytes);
      raw.ptr<float> (row, col)[i] =
          std::isfinite (value) ? static_cast<float> (value) : 0.0F;
    }
  });
  return raw;
}

bool
areBytes (const std::vector<CloudChannel>& channels)
{
  for (const CloudChannel& channel : channels)
    if (channel.type != pcl::PCLPointField::UINT8)
      return false;
  return true;
}

} // namespace

void
takeColors (const pcl::PCLPointCloud2& cloud,
            const CloudFields& fields,
            RgbdImages& images)
{
  const std::vector<CloudChannel>& numbers = fields.colorNumbers();
  if (fields.packedColor())
    images.color = unpacked (cloud, *fields.packedColor());
  else if (!numbers.empty()) {
    const cv::Mat raw = numbersOf (cloud, numbers);
    if (areBytes (numbers)) {
      raw.convertTo (images.color, CV_8U);
      if (numbers.size() == 1)
        cv::cvtColor (images.color, images.color, cv::COLOR_GRAY2BGR);
    }
    else {
      images.raw_color = raw;
      unifyColors ({&images});
    }
  }
  else {
    images.note = "no colour found (fields";
    for (const auto& field : cloud.fields)
      images.note += " " + field.name;
    images.note += "): geometry alone";
  }
}

} // namespace pcl_msf::io
