// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors

// clang-format off
#include <pcl/features/feature.h>
#include <pcl/point_types.h>

#include <memory>

// PCL's templates, made here, as libpcl_features takes 0.05 s of the start of each
// program that is linked with it. For types of this file alone, under a name of its own,
// and with an allocator that no compiler's flags change: a program that has PCL's, too,
// may be compiled with others, see build_compatibility.h.
namespace Eigen {
template <typename T>
using PclMsfAllocator = std::allocator<T>;
}
#define IntegralImage2D PclMsfIntegralImage2D
#define aligned_allocator PclMsfAllocator
#include <pcl/features/integral_image2D.h>
#undef aligned_allocator
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/impl/integral_image_normal.hpp>
// clang-format on

#include "core/base/flatten.h"
#include "core/frame/normals.h"

#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

struct OwnNormal : pcl::Normal {};

[[gnu::noinline]] void
estimate (const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
          pcl::PointCloud<OwnNormal>& normals)
{
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, OwnNormal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setMaxDepthChangeFactor (0.02f);
  estimation.setNormalSmoothingSize (10.0f);
  estimation.setInputCloud (cloud);
  estimation.compute (normals);
}

} // namespace

// Flat, so that no copy of the clouds' functions is left that a program's own, with
// another allocator, could replace.
PCL_MSF_FLATTEN cv::Mat
normalsByIntegralImage (const cv::Mat& w, const PinholeCamera& camera)
{
  // Both clouds are made and freed here and keep their size: what frees or enlarges
  // them elsewhere may be compiled with another allocator, see build_compatibility.h.
  pcl::PointCloud<pcl::PointXYZ> cloud (w.cols, w.rows);
  pcl::PointCloud<OwnNormal> found (w.cols, w.rows);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int y = 0; y < w.rows; ++y)
    for (int x = 0; x < w.cols; ++x) {
      const float value = w.at<float> (y, x);
      const float z = value > 0.0f ? 1.0f / value : nan;
      cloud.at (x, y).getVector3fMap() = camera.backProject (x, y, z).cast<float>();
    }
  estimate (pcl::PointCloud<pcl::PointXYZ>::ConstPtr (std::shared_ptr<void>(), &cloud),
            found);
  cv::Mat normals = cv::Mat::zeros (w.size(), CV_32FC3);
  for (int y = 0; y < w.rows; ++y)
    for (int x = 0; x < w.cols; ++x) {
      const OwnNormal& n = found.at (x, y);
      if (std::isfinite (n.normal_x))
        normals.at<cv::Vec3f> (y, x) = {n.normal_x, n.normal_y, n.normal_z};
    }
  return normals;
}

} // namespace pcl_msf
