// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/type_traits.h>

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_msf {

namespace detail {

/** Was the point measured? Not when it is NaN, or (0, 0, 0), as some drivers say it. */
template <typename PointT>
bool
hasDepth (const PointT& point)
{
  return pcl::isXYZFinite (point) && point.z > 0.0f;
}

template <typename PointT, typename Field>
constexpr bool has_field = pcl::traits::has_field<PointT, Field>::value;

/** The image that `pixel_of (point)` makes of an organized cloud. */
template <typename Pixel, typename PointT, typename Function>
cv::Mat
mapPoints (const pcl::PointCloud<PointT>& cloud, Function pixel_of)
{
  const int width = static_cast<int> (cloud.width);
  const int height = static_cast<int> (cloud.height);
  cv::Mat image (height, width, cv::traits::Type<Pixel>::value);
  for (int v = 0; v < height; ++v) {
    auto* row = image.ptr<Pixel> (v);
    const PointT* points = cloud.data() + static_cast<std::size_t> (v) * width;
    for (int u = 0; u < width; ++u)
      row[u] = pixel_of (points[u]);
  }
  return image;
}

inline cv::Vec3f
noPoint ()
{
  return cv::Vec3f::all (std::numeric_limits<float>::quiet_NaN());
}

/** rgb and rgba are four bytes B, G, R, A, whatever type the field has. */
template <typename Field, typename PointT>
cv::Vec3b
packedColor (const PointT& point)
{
  unsigned char bgra[4];
  std::memcpy (bgra,
               reinterpret_cast<const unsigned char*> (&point) +
                   pcl::traits::offset<PointT, Field>::value,
               sizeof (bgra));
  return {bgra[0], bgra[1], bgra[2]};
}

/** As it is in the cloud. */
template <typename PointT>
float
readIntensity (const PointT& point)
{
  using Field = pcl::fields::intensity;
  using Value = typename pcl::traits::datatype<PointT, Field>::type;
  Value value;
  pcl::getFieldValue<PointT, Value> (
      point, pcl::traits::offset<PointT, Field>::value, value);
  return static_cast<float> (value);
}

/** 0 where it is not finite. */
template <typename PointT>
float
rawIntensity (const PointT& point)
{
  const float intensity = readIntensity (point);
  return std::isfinite (intensity) ? intensity : 0.0f;
}

/** Is the cloud an image? One row is none, nor is one column. */
template <typename PointT>
bool
isGrid (const pcl::PointCloud<PointT>& cloud)
{
  return cloud.width > 1 && cloud.height > 1 &&
         static_cast<std::size_t> (cloud.width) * cloud.height == cloud.size();
}

/** Message of a cloud that is no image, with the remedy. */
template <typename PointT>
std::string
notOrganized (const pcl::PointCloud<PointT>& cloud, const std::string& name)
{
  return "the " + name + " is not organized (" + std::to_string (cloud.width) + "x" +
         std::to_string (cloud.height) + ", " + std::to_string (cloud.size()) +
         " points): give the whole image with NaN where there is no "
         "depth; filters keep it so with setKeepOrganized (true)";
}

} // namespace detail

template <typename PointT>
void
requireOrganized (const pcl::PointCloud<PointT>& cloud, const std::string& name)
{
  if (cloud.empty())
    throw InvalidInput ("the " + name + " is empty: give an organized cloud");
  const std::size_t area = static_cast<std::size_t> (cloud.width) * cloud.height;
  if (cloud.height > 1 && area == cloud.size())
    return;
  throw InvalidInput (detail::notOrganized (cloud, name));
}

template <typename PointT>
cv::Mat
coordinateImage (const pcl::PointCloud<PointT>& cloud)
{
  requireOrganized (cloud, "cloud");
  return detail::mapPoints<cv::Vec3f> (cloud, [] (const PointT& p) {
    return pcl::isXYZFinite (p) ? cv::Vec3f (p.x, p.y, p.z) : detail::noPoint();
  });
}

template <typename PointT>
cv::Mat
pointImage (const pcl::PointCloud<PointT>& cloud)
{
  requireOrganized (cloud, "cloud");
  return detail::mapPoints<cv::Vec3f> (cloud, [] (const PointT& p) {
    return detail::hasDepth (p) ? cv::Vec3f (p.x, p.y, p.z) : detail::noPoint();
  });
}

template <typename PointT>
cv::Mat
colorImage (const pcl::PointCloud<PointT>& cloud)
{
  using namespace pcl::fields;
  requireOrganized (cloud, "cloud");
  if constexpr (detail::has_field<PointT, rgb>)
    return detail::mapPoints<cv::Vec3b> (cloud, detail::packedColor<rgb, PointT>);
  else if constexpr (detail::has_field<PointT, rgba>)
    return detail::mapPoints<cv::Vec3b> (cloud, detail::packedColor<rgba, PointT>);
  else if constexpr (detail::has_field<PointT, intensity>)
    return detail::mapPoints<float> (cloud, detail::rawIntensity<PointT>);
  return {};
}

} // namespace pcl_msf
