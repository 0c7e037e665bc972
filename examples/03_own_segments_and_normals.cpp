// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Segments and normals from elsewhere, here from PCL and from the truth.
#include <pcl/features/integral_image_normal.h>

#include "example_clouds.h"
#include <pcl_msf/piecewise_rigid_registration.h>

#include <iostream>

int
main ()
{
  const Cloud::Ptr reference = exampleCloud (0);

  // A label per point; the largest value of the type = no segment.
  const cv::Mat& bodies = exampleSequence().labels;
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (160, 120);
  for (int i = 0; i < 160 * 120; ++i) {
    const int body = bodies.at<int> (i);
    (*labels)[i].label = body < 0 ? std::numeric_limits<std::uint32_t>::max() : body;
  }

  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::IntegralImageNormalEstimation<pcl::PointXYZRGBA, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setInputCloud (reference);
  estimation.compute (*normals);

  pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGBA> registration;
  registration.setSegmentation (labels);
  registration.setSourceNormals (normals);
  registration.setInputSource (reference);
  registration.setInputTarget (exampleCloud (1));
  Cloud warped;
  registration.align (warped);
  for (const pcl_msf::SegmentMotion& segment : registration.getSceneFlow().segments)
    std::cout << segment.current_from_reference.translation().transpose() << " m\n";
  return registration.hasConverged() ? 0 : 1;
}
