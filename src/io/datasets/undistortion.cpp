// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/io/undistortion.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::io {

namespace {

constexpr float kSameSurface = 0.01F; // relative difference of neighbouring depths

/** CV_32FC2: for each pixel of a pinhole camera the place in the lens's image. */
cv::Mat
placesOf (const RgbdImages& frame, const LensDistortion& lens, const cv::Size& size)
{
  cv::Mat places (size, CV_32FC2);
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      const Eigen::Vector2d p = lens.distortedPixel (frame.camera, u, v);
      places.at<cv::Vec2f> (v, u) = {static_cast<float> (p.x()),
                                     static_cast<float> (p.y())};
    }
  return places;
}

/** The four pixels around a place, and where it lies between them. */
struct Cell {
  int left, top, right, bottom;
  float x, y;

  /** Places outside are moved to the border. */
  Cell (const cv::Vec2f& place, const cv::Size& size)
  {
    const float u = std::clamp (place[0], 0.0F, static_cast<float> (size.width - 1));
    const float v = std::clamp (place[1], 0.0F, static_cast<float> (size.height - 1));
    left = static_cast<int> (u);
    top = static_cast<int> (v);
    right = std::min (left + 1, size.width - 1);
    bottom = std::min (top + 1, size.height - 1);
    x = u - static_cast<float> (left);
    y = v - static_cast<float> (top);
  }

  template <typename Value>
  Value
  mix (const Value& a, const Value& b, const Value& c, const Value& d) const
  {
    return (a * (1.0F - x) + b * x) * (1.0F - y) + (c * (1.0F - x) + d * x) * y;
  }
};

template <int Channels>
cv::Mat
mixColors (const cv::Mat& image, const cv::Mat& places)
{
  using Pixel = cv::Vec<float, Channels>;
  cv::Mat from, to (image.size(), CV_32FC (Channels));
  image.convertTo (from, CV_32F);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u) {
      const Cell cell (places.at<cv::Vec2f> (v, u), image.size());
      const auto* top = from.ptr<Pixel> (cell.top);
      const auto* bottom = from.ptr<Pixel> (cell.bottom);
      to.at<Pixel> (v, u) = cell.mix (
          top[cell.left], top[cell.right], bottom[cell.left], bottom[cell.right]);
    }
  cv::Mat result;
  to.convertTo (result, image.depth());
  return result;
}

cv::Mat
undistortedColor (const RgbdImages& frame,
                  const LensDistortion& lens,
                  const cv::Mat& image)
{
  if (image.empty())
    return image;
  const cv::Mat places = placesOf (frame, lens, image.size());
  return image.channels() == 1 ? mixColors<1> (image, places)
                               : mixColors<3> (image, places);
}

float
depthAt (const cv::Mat& depth, const cv::Vec2f& place)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float u = std::round (place[0]), v = std::round (place[1]);
  if (!(u >= 0.0F && v >= 0.0F && u < static_cast<float> (depth.cols) &&
        v < static_cast<float> (depth.rows)))
    return nan;
  const Cell cell (place, depth.size());
  const float a = depth.at<float> (cell.top, cell.left);
  const float b = depth.at<float> (cell.top, cell.right);
  const float c = depth.at<float> (cell.bottom, cell.left);
  const float d = depth.at<float> (cell.bottom, cell.right);
  const float low = std::min ({a, b, c, d}), high = std::max ({a, b, c, d});
  const bool known = std::isfinite (a + b + c + d) && low > 0.0F;
  if (known && high - low < kSameSurface * low)
    return 1.0F / cell.mix (1.0F / a, 1.0F / b, 1.0F / c, 1.0F / d);
  return depth.at<float> (static_cast<int> (v), static_cast<int> (u));
}

} // namespace

void
undistort (RgbdImages& frame, const LensDistortion& lens)
{
  if (lens.isNone())
    return;
  std::string why;
  const cv::Size size = frame.depth.size();
  if (!frame.distortion.isNone())
    why = "the frame was freed from a distortion before; do it once";
  if (!why.empty() || !frame.camera.isValid (size.width, size.height, &why) ||
      !lens.isValid (frame.camera, size.width, size.height, &why))
    throw InvalidInput ("distortion: " + why);
  const cv::Mat places = placesOf (frame, lens, size);
  cv::Mat depth (size, CV_32FC1); // not in place: copies of the frame share images
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u)
      depth.at<float> (v, u) = depthAt (frame.depth, places.at<cv::Vec2f> (v, u));
  frame.depth = depth;
  frame.color = undistortedColor (frame, lens, frame.color);
  frame.raw_color = undistortedColor (frame, lens, frame.raw_color);
  frame.distortion = lens;
}

} // namespace pcl_msf::io
