// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// With regions that PCL grows by its normals: the sides of a body's limbs.
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include "example_pictures.h"

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

int
main ()
{
  pcl_msf::synthetic::BodyOptions options;
  options.body = pcl_msf::synthetic::BodyKind::Animal;
  options.points = 12000;
  const auto body = pcl_msf::synthetic::synthesizeBody (options);
  const auto source = cloudOf<Point> (body.source);
  const auto target = cloudOf<Point> (body.target);

  const auto tree = pcl::make_shared<pcl::search::KdTree<Point>>();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationOMP<Point, pcl::Normal> estimation;
  estimation.setSearchMethod (tree);
  estimation.setInputCloud (source);
  estimation.setKSearch (15);
  estimation.compute (*normals);
  pcl::RegionGrowing<Point, pcl::Normal> growing;
  growing.setMinClusterSize (30);
  growing.setSearchMethod (tree);
  growing.setNumberOfNeighbours (15);
  growing.setInputCloud (source);
  growing.setInputNormals (normals);
  growing.setSmoothnessThreshold (0.1F); // radians
  std::vector<pcl::PointIndices> regions;
  growing.extract (regions);

  pcl_msf::PiecewiseRigidRegistration<Point> registration;
  registration.setInputSource (source);
  registration.setInputTarget (target);
  registration.setSegmentation (regions);
  Cloud warped;
  registration.align (warped);
  const bool drawn =
      writePicture ("grown_regions.png", registration, *source, warped, *target);
  return drawn && registration.hasConverged() ? 0 : 1;
}
