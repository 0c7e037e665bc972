// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/piecewise_rigid_registration.h>
#include <pcl_msf/piecewise_rigid_tracker.h>

#include <cmath>
#include <cstdio>

/** A textured, curved surface, `away` metres behind its place. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
wavyCloud (float away)
{
  const pcl_msf::PinholeCamera camera{60.0, 60.0, 31.5, 23.5};
  typename pcl::PointCloud<PointT>::Ptr cloud (new pcl::PointCloud<PointT>);
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u) {
      const double wave = std::sin (0.3 * u) * std::cos (0.2 * v);
      PointT point{};
      point.getVector3fMap() =
          camera.backProject (u, v, 1.0 + away + 0.1 * wave).template cast<float>();
      cloud->push_back (point); // grows the memory in this code
    }
  cloud->width = 64;
  cloud->height = 48;
  return cloud;
}

/** All that hands matrices, clouds or results over to the library and back. */
template <typename PointT>
bool
registers ()
{
  const auto source = wavyCloud<PointT> (0.0f);
  const auto target = wavyCloud<PointT> (0.02f);
  auto registration = pcl::make_shared<pcl_msf::PiecewiseRigidRegistration<PointT>>();
  typename pcl::Registration<PointT, PointT>::Ptr base = registration;
  base->setInputSource (source);
  registration->setInputTargets ({target, target});
  pcl_msf::FrameParameters frame;
  frame.normals = pcl_msf::NormalMethod::IntegralImage;
  registration->setFrameParameters (frame);
  pcl::PointCloud<PointT> warped;
  base->align (warped, Eigen::Matrix4f::Identity());
  const pcl_msf::SceneFlow flow = registration->getSceneFlow();
  const Eigen::Matrix4f pose = registration->getPose (0, 1, 0);
  const auto back = pcl_msf::RigidPose::fromMatrix (pose);
  const bool same = (back.matrix() - pose).norm() < 1e-5f;

  pcl_msf::PiecewiseRigidTracker<PointT> tracker;
  const bool tracked = tracker.addCloud (source) && tracker.addCloud (target);
  const float moved = warped (32, 24).z - (*source) (32, 24).z;
  std::printf ("converged %d, moved %g m, nearest %g, tracked %d, pose kept %d\n",
               registration->hasConverged(),
               moved,
               base->getFitnessScore(),
               tracked,
               same);
  return registration->hasConverged() && std::abs (moved - 0.02f) < 5e-3f && same &&
         tracked && tracker.getWarpedCloud().size() == source->size() &&
         base->getFitnessScore() < 1e-3 && !flow.segments.empty();
}
