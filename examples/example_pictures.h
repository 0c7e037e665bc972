// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_msf/io/images.h>
#include <pcl_msf/motion_clusters.h>
#include <pcl_msf/piecewise_rigid_registration.h>
#include <pcl_msf/synthetic/body_clouds.h>
#include <pcl_msf/visualization/cloud_scenes.h>
#include <pcl_msf/visualization/offscreen_renderer.h>
#include <pcl_msf/visualization/picture_sheet.h>
#include <pcl_msf/visualization/virtual_display.h>

#include <iostream>
#include <string>
#include <vector>

// What the examples of PCL's own machinery share: clouds, and pictures of what was
// found.

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
cloudOf (const std::vector<Eigen::Vector3f>& points)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
  for (const Eigen::Vector3f& p : points) {
    PointT point;
    point.getVector3fMap() = p;
    cloud->push_back (point);
  }
  return cloud;
}

template <typename PointT>
std::vector<Eigen::Vector3f>
pointsOf (const pcl::PointCloud<PointT>& cloud)
{
  std::vector<Eigen::Vector3f> points;
  for (const PointT& p : cloud)
    points.emplace_back (p.getVector3fMap());
  return points;
}

/** Source and target, warped source and target, parts and joints: side by side in a
 * file. Runs with or without a display. \return could it? else stderr has the remedy */
template <typename PointT>
bool
writePicture (const std::string& file,
              const pcl_msf::PiecewiseRigidRegistration<PointT>& registration,
              const pcl::PointCloud<PointT>& source,
              const pcl::PointCloud<PointT>& warped,
              const pcl::PointCloud<PointT>& target)
{
  using namespace pcl_msf::visualization;
  CloudResult result;
  result.source = pointsOf (source);
  result.warped = pointsOf (warped);
  result.target = pointsOf (target);
  const pcl_msf::SceneFlow& flow = registration.getSceneFlow();
  if (!target.isOrganized()) // joints are of clouds without a grid
    result.joints = registration.getJoints();
  for (std::size_t i = 0; i < source.size(); ++i)
    result.part.push_back (pcl_msf::motionGroupOf (flow, i));
  PictureStyle style;
  style.size = {400, 300};
  const View view = orbitView (cloudBounds (result.target), style.size, 25.0, 15.0);
  try {
    static OffscreenRenderer renderer; // starts an Xvfb where there is no display
    std::vector<cv::Mat> pictures;
    for (const PictureKind kind :
         {PictureKind::BeforeTints, PictureKind::AfterTints, PictureKind::Motions})
      pictures.push_back (renderer.render (cloudScene (kind, result), view, style));
    pcl_msf::io::writeImage (file, pictureSheet (pictures, 3, {255, 255, 255}));
  }
  catch (const DisplayError& error) {
    std::cerr << error.what() << "\n";
    return false;
  }
  std::cout << file << ": " << source.size() << " points, " << flow.groups
            << " motion groups\n";
  return true;
}
