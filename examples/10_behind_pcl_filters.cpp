// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Behind PCL's filters, which leave clouds with a grid or without, and a picture each.
#include <pcl/filters/fast_bilateral.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>

#include "example_clouds.h"
#include "example_pictures.h"

bool all_well = true;

template <typename PointT>
void
registerBehind (pcl::Filter<PointT>& filter,
                const std::string& picture,
                const typename pcl::PointCloud<PointT>::ConstPtr& source,
                const typename pcl::PointCloud<PointT>::ConstPtr& target)
{
  const auto from = pcl::make_shared<pcl::PointCloud<PointT>>();
  const auto to = pcl::make_shared<pcl::PointCloud<PointT>>();
  filter.setInputCloud (source);
  filter.filter (*from);
  filter.setInputCloud (target);
  filter.filter (*to);
  pcl_msf::PiecewiseRigidRegistration<PointT> registration;
  registration.setInputSource (from);
  registration.setInputTarget (to);
  pcl::PointCloud<PointT> warped;
  registration.align (warped);
  all_well = writePicture (picture, registration, *from, warped, *to) &&
             registration.hasConverged() && all_well;
}

int
main ()
{
  pcl_msf::synthetic::BodyOptions options;
  options.outliers = 0.1;
  const auto body = pcl_msf::synthetic::synthesizeBody (options);
  const auto source = cloudOf<pcl::PointXYZ> (body.source);
  const auto target = cloudOf<pcl::PointXYZ> (body.target);
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setLeafSize (0.015F, 0.015F, 0.015F);
  registerBehind (grid, "voxel_grid.png", source, target);
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> outliers;
  outliers.setMeanK (20);
  outliers.setStddevMulThresh (1.0);
  registerBehind (outliers, "statistical_outlier_removal.png", source, target);
  pcl::PassThrough<pcl::PointXYZRGBA> pass; // what is near: the arm and the floor
  pass.setFilterFieldName ("z");
  pass.setFilterLimits (0.0F, 2.6F);
  pass.setKeepOrganized (true);
  registerBehind (pass, "pass_through.png", exampleCloud (0), exampleCloud (1));
  pcl::FastBilateralFilter<pcl::PointXYZRGBA> bilateral;
  registerBehind (bilateral, "fast_bilateral.png", exampleCloud (0), exampleCloud (1));
  return all_well ? 0 : 1;
}
