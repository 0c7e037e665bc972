// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Two scans of an articulated body: its parts and joints; then with what is known.
#include <pcl_msf/motion_clusters.h>
#include <pcl_msf/piecewise_rigid_registration.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <iostream>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr
cloudOf (const std::vector<Eigen::Vector3f>& points)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const auto& p : points)
    cloud->emplace_back (p.x(), p.y(), p.z());
  return cloud;
}

int
main ()
{
  const pcl_msf::synthetic::BodyClouds body = pcl_msf::synthetic::synthesizeBody ({});
  pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZ> registration;
  registration.setInputSource (cloudOf (body.source));
  registration.setInputTarget (cloudOf (body.target));
  Cloud warped;
  registration.align (warped);
  for (const pcl::PointIndices& part :
       pcl_msf::motionClusters (registration.getSceneFlow()))
    std::cout << "a part of " << part.indices.size() << " points\n";
  for (const pcl_msf::CloudJoint& joint : registration.getJoints())
    std::cout << "part " << joint.child << " turns against part " << joint.parent
              << " by " << joint.angle << " rad about " << joint.axis.transpose()
              << "\n";
  const bool found = registration.hasConverged();

  // The links as segments; the first one is held, and so is a point of the last one.
  std::vector<pcl::PointIndices> links (body.poses.size());
  for (std::size_t i = 0; i < body.link.size(); ++i)
    links[body.link[i]].indices.push_back (static_cast<int> (i));
  registration.setSegmentation (links);
  pcl_msf::CloudConstraints known;
  known.guesses = {{0, body.poses[0]}};
  known.fixed_segments = {0};
  known.pairs = {{links.back().indices[0], 0, 1.0}}; // weight 1: may be a bit off
  const Eigen::Vector3f truth = body.truth[links.back().indices[0]];
  for (std::size_t j = 1; j < body.target.size(); ++j)
    if ((body.target[j] - truth).norm() <
        (body.target[known.pairs[0].target] - truth).norm())
      known.pairs[0].target = static_cast<int> (j);
  registration.setCloudConstraints (known);
  registration.align (warped);
  return found && registration.hasConverged() ? 0 : 1;
}
