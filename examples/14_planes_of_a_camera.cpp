// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// With the planes of an organized cloud as segments, and their normals.
#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include "example_clouds.h"
#include "example_pictures.h"

using Point = pcl::PointXYZRGBA;

int
main ()
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::IntegralImageNormalEstimation<Point, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setInputCloud (exampleCloud (0));
  estimation.compute (*normals);
  pcl::OrganizedMultiPlaneSegmentation<Point, pcl::Normal, pcl::Label> segmentation;
  segmentation.setMinInliers (200);
  segmentation.setInputCloud (exampleCloud (0));
  segmentation.setInputNormals (normals);
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> planes;
  segmentation.segment (models, planes);

  pcl_msf::PiecewiseRigidRegistration<Point> registration;
  registration.setInputSource (exampleCloud (0));
  registration.setInputTarget (exampleCloud (1));
  registration.setSourceNormals (normals);
  registration.setSegmentation (planes); // what is in none is unknown in the result
  Cloud warped;
  registration.align (warped);
  const bool drawn = writePicture (
      "planes.png", registration, *exampleCloud (0), warped, *exampleCloud (1));
  std::cout << planes.size() << " planes\n";
  return drawn && registration.hasConverged() ? 0 : 1;
}
