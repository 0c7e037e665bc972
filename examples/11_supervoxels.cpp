// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// With PCL's supervoxels as segments, which the registration joins to parts.
#include <pcl/segmentation/supervoxel_clustering.h>

#include "example_pictures.h"

#include <map>

using Point = pcl::PointXYZRGBA;
using Cloud = pcl::PointCloud<Point>;

/** Labels of a point each; the largest number: in none. */
pcl::PointCloud<pcl::Label>::Ptr
supervoxels (const Cloud::Ptr& cloud)
{
  pcl::SupervoxelClustering<Point> clustering (0.02F, 0.1F); // metres: voxel, seed
  clustering.setUseSingleCameraTransform (false);
  clustering.setInputCloud (cloud);
  clustering.setColorImportance (0.0F);
  std::map<std::uint32_t, pcl::Supervoxel<Point>::Ptr> unused;
  clustering.extract (unused);
  const auto labels = clustering.getLabeledCloud();
  const auto result = pcl::make_shared<pcl::PointCloud<pcl::Label>> (cloud->size(), 1);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*result)[i].label = (*labels)[i].label - 1; // 0 there: in none
  return result;
}

int
main ()
{
  const auto body = pcl_msf::synthetic::synthesizeBody ({});
  const auto source = cloudOf<Point> (body.source);
  const auto target = cloudOf<Point> (body.target);
  pcl_msf::PiecewiseRigidRegistration<Point> registration;
  registration.setInputSource (source);
  registration.setInputTarget (target);
  registration.setSegmentation (supervoxels (source));
  Cloud warped;
  registration.align (warped);
  const bool drawn =
      writePicture ("supervoxels.png", registration, *source, warped, *target);
  return drawn && registration.hasConverged() ? 0 : 1;
}
