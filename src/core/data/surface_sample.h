// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include "core/base/bilinear.h"
#include "core/data/data_kernel.h"

#include <cmath>

namespace pcl_msf {

/** \brief A place in an image, pixels; the first pixel's centre is (0, 0). */
struct ImagePlace {
  float u{0.0f};
  float v{0.0f};
};

/** \brief Where a point of the image's camera frame, in metres, appears; it must lie
 * before the camera. */
inline ImagePlace
projectTo (const kernel::Image& image, const Eigen::Vector3f& q)
{
  return {image.fx * q.x() / q.z() + image.cx, image.fy * q.y() / q.z() + image.cy};
}

/** \brief Does a place lie between the centres of four pixels? */
inline bool
isBetweenPixels (const kernel::Image& image, const ImagePlace& at)
{
  return at.u >= 0.0f && at.v >= 0.0f && at.u < static_cast<float> (image.width - 1) &&
         at.v < static_cast<float> (image.height - 1);
}

/** \brief Does a place lie on a pixel, at most half of one from its centre? */
inline bool
isOnPixel (const kernel::Image& image, const ImagePlace& at)
{
  return at.u > -0.5f && at.v > -0.5f &&
         at.u < static_cast<float> (image.width) - 0.5f &&
         at.v < static_cast<float> (image.height) - 0.5f;
}

/** \brief Bilinear intensity, 0 <= u < width - 1 and 0 <= v < height - 1. */
inline float
intensityAt (const kernel::Image& image, const ImagePlace& at)
{
  const int u0 = static_cast<int> (at.u);
  const int v0 = static_cast<int> (at.v);
  const float a = at.u - static_cast<float> (u0);
  const float b = at.v - static_cast<float> (v0);
  const float* t = image.texels + 2 * (v0 * image.width + u0);
  const float* s = t + 2 * image.width;
  return bilinear (a, b, t[0], t[2], s[0], s[2]);
}

/** \brief Inverse depth of the nearest pixel, 1 / metres, 0 = none; half a pixel beyond
 * the border still has one. */
inline float
inverseDepthAt (const kernel::Image& image, const ImagePlace& at)
{
  const int row = static_cast<int> (at.v + 0.5f);
  return image.texels[2 * (row * image.width + static_cast<int> (at.u + 0.5f)) + 1];
}

/** \brief Is a point on the surface whose inverse depth the frame shows where it lands?
 * \param shown 0 = no surface \param z of the point, metres \param tolerance of the
 * inverse depth */
inline bool
isOnSurface (float shown, float z, float tolerance)
{
  return shown > 0.0f && std::abs (shown - 1.0f / z) <= tolerance;
}

/** \brief How far a point on the surface that the frame shows is from the surface's
 * plane, metres (Eq. 8). \param q the point \param normal there, turned with it */
inline float
planeDistance (const Eigen::Vector3f& q, const Eigen::Vector3f& normal, float shown)
{
  return normal.dot (q) * (1.0f - 1.0f / (q.z() * shown));
}

} // namespace pcl_msf
