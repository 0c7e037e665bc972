// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/depth_points.h"

#include <cmath>
#include <limits>

namespace pcl_msf::tool {

cv::Mat
pointsOf (const io::RgbdImages& images)
{
  cv::Mat points (images.depth.size(),
                  CV_32FC3,
                  cv::Scalar::all (std::numeric_limits<float>::quiet_NaN()));
  for (int y = 0; y < points.rows; ++y)
    for (int x = 0; x < points.cols; ++x) {
      const float z = images.depth.at<float> (y, x);
      if (!(z > 0.0f) || !std::isfinite (z))
        continue;
      const Eigen::Vector3f p = images.camera.backProject (x, y, z).cast<float>();
      points.at<cv::Vec3f> (y, x) = {p.x(), p.y(), p.z()};
    }
  return points;
}

} // namespace pcl_msf::tool
