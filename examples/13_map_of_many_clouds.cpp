// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// In PCL's incremental and meta registration: a scanner that moves on makes a map.
#include <pcl/common/transforms.h>
#include <pcl/registration/incremental_registration.h>
#include <pcl/registration/meta_registration.h>

#include "example_pictures.h"

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

/** From where the scanner began to its frame after some steps. */
Eigen::Affine3f
wayOf (int step)
{
  Eigen::Affine3f way (Eigen::AngleAxisf (0.06F * step, Eigen::Vector3f::UnitY()));
  way.translation() = Eigen::Vector3f (0.02F, 0.01F, -0.02F) * step;
  return way;
}

/** A body that stands still, as the scanner sees it after some steps; drawn anew. */
Cloud::Ptr
scan (int step)
{
  pcl_msf::synthetic::BodyOptions options;
  options.body = pcl_msf::synthetic::BodyKind::Animal;
  options.angle = 0.0;
  options.seed = 7 + step;
  const auto cloud =
      cloudOf<Point> (pcl_msf::synthetic::synthesizeBody (options).source);
  pcl::transformPointCloud (*cloud, *cloud, wayOf (step));
  return cloud;
}

int
main ()
{
  using Registration = pcl_msf::PiecewiseRigidRegistration<Point>;
  const auto registration = pcl::make_shared<Registration>();
  pcl::registration::IncrementalRegistration<Point> incremental; // to the last scan
  incremental.setRegistration (registration);
  pcl::registration::MetaRegistration<Point> meta; // to the map of all
  meta.setRegistration (pcl::make_shared<Registration>());
  bool registered = true;
  for (int step = 0; step < 4; ++step)
    registered = incremental.registerCloud (scan (step)) &&
                 meta.registerCloud (scan (step)) && registered;
  std::cout << "the scanner's way back:\n" << meta.getAbsoluteTransform() << "\n";
  Cloud back;
  pcl::transformPointCloud (*scan (3), back, meta.getAbsoluteTransform());
  const bool drawn =
      writePicture ("map.png", *registration, *scan (3), back, *meta.getMetaCloud());
  for (const auto& found :
       {incremental.getAbsoluteTransform(), meta.getAbsoluteTransform()})
    registered = registered && (found * wayOf (3).matrix()).isIdentity (0.005F);
  return drawn && registered ? 0 : 1;
}
