// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/io/rgbd_images.h>

#include <optional>

namespace pcl_msf::tool {

/** \brief Turns the organized clouds of one sensor into images. */
class CloudImages {
public:
  /** \param camera of the clouds, pixels; none = the first cloud's points tell it
   * \param units_per_metre of x y z, > 0 */
  explicit CloudImages (std::optional<PinholeCamera> camera,
                        double units_per_metre = 1.0)
  : camera_ (std::move (camera)), units_per_metre_ (units_per_metre)
  {}

  /** \throws InvalidInput for a cloud that is no image, or not of the camera */
  template <typename PointT>
  io::RgbdImages
  convert (const pcl::PointCloud<PointT>& cloud)
  {
    requireOrganized (cloud, "cloud");
    io::RgbdImages images;
    images.camera = cameraOf (coordinateImage (cloud));
    images.depth = depthImage (pointImage (cloud));
    if (units_per_metre_ != 1.0)
      images.depth /= units_per_metre_;
    takeColor (colorImage (cloud), images);
    const auto& t = cloud.sensor_origin_;
    const auto& q = cloud.sensor_orientation_;
    images.viewpoint = {{t.x(), t.y(), t.z()}, {q.w(), q.x(), q.y(), q.z()}};
    return images;
  }

private:
  PinholeCamera
  cameraOf (const cv::Mat& coordinates);
  static void
  takeColor (const cv::Mat& color, io::RgbdImages& images);

  std::optional<PinholeCamera> camera_;
  double units_per_metre_;
};

} // namespace pcl_msf::tool
