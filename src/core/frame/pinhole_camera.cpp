// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include <pcl_msf/pinhole_camera.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf {

bool
PinholeCamera::isValid (int width, int height, std::string* why) const
{
  const double side = std::max (width, height);
  const auto focal_ok = [side] (double f) {
    return std::isfinite (f) && f >= 0.01 * side && f <= 100.0 * side;
  };
  const auto center_ok = [] (double c, double size) {
    return std::isfinite (c) && c >= -size && c <= 2.0 * size;
  };
  const bool ok = width > 0 && height > 0 && focal_ok (fx) && focal_ok (fy) &&
                  center_ok (cx, width) && center_ok (cy, height);
  if (!ok && why) {
    *why = "no camera for " + std::to_string (width) + "x" + std::to_string (height) +
           " images: fx " + generalText (fx) + ", fy " + generalText (fy) + ", cx " +
           generalText (cx) + ", cy " + generalText (cy);
    if (fx < 0.0 || fy < 0.0) // as some data sets have for images upside down
      *why += "; focal lengths must be positive: flip the images and the principal "
              "point instead";
    else
      *why += "; give focal lengths and principal point in pixels";
  }
  return ok;
}

} // namespace pcl_msf
