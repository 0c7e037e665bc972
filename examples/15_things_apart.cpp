// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// With things that stand apart as segments: each moves on its own.
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include "example_pictures.h"

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

int
main ()
{
  auto body = pcl_msf::synthetic::synthesizeBody ({});
  for (std::size_t i = 0; i < body.source.size(); ++i)
    for (auto* points : {&body.source, &body.truth}) // its links, taken apart
      (*points)[i].y() += 0.4F * static_cast<float> (body.link[i]);
  const auto source = cloudOf<Point> (body.source);
  const auto target = cloudOf<Point> (body.truth);
  std::vector<pcl::PointIndices> clusters;
  pcl::EuclideanClusterExtraction<Point> extraction;
  extraction.setClusterTolerance (0.1); // metres
  extraction.setSearchMethod (pcl::make_shared<pcl::search::KdTree<Point>>());
  extraction.setInputCloud (source);
  extraction.extract (clusters);

  pcl_msf::PiecewiseRigidRegistration<Point> registration;
  registration.setInputSource (source);
  registration.setInputTarget (target);
  registration.setSegmentation (clusters);
  Cloud warped;
  registration.align (warped);
  const bool drawn =
      writePicture ("clusters.png", registration, *source, warped, *target);
  return drawn && registration.hasConverged() && clusters.size() == 4 ? 0 : 1;
}
