// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

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
  return (1.0f - b) * ((1.0f - a) * t[0] + a * t[2]) +
         b * ((1.0f - a) * s[0] + a * s[2]);
}

/** \brief Inverse depth of the nearest pixel, 1 / metres, 0 = none; half a pixel beyond
 * the border still has one. */
inline float
inverseDepthAt (const kernel::Image& image, const ImagePlace& at)
{
  const int row = static_cast<int> (at.v + 0.5f);
  return image.texels[2 * (row * image.width + static_cast<int> (at.u + 0.5f)) + 1];
}

} // namespace pcl_msf
