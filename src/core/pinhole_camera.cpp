// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/pinhole_camera.h>

#include <algorithm>
#include <cmath>
#include <sstream>

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
    std::ostringstream text;
    text << "no camera for " << width << "x" << height << " images: fx " << fx
         << ", fy " << fy << ", cx " << cx << ", cy " << cy
         << "; give focal lengths and principal point in pixels";
    *why = text.str();
  }
  return ok;
}

} // namespace pcl_msf
