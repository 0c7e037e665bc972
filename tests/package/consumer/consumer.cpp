// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cmath>

/** Registers a textured, curved surface to itself through the installed library. */
int
main ()
{
  using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;
  const pcl_msf::PinholeCamera camera{60.0, 60.0, 31.5, 23.5};
  const auto cloud = pcl::make_shared<Cloud> (64, 48);
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u) {
      const double wave = std::sin (0.3 * u) * std::cos (0.2 * v);
      auto& point = (*cloud) (u, v);
      point.getVector3fMap() =
          camera.backProject (u, v, 1.0 + 0.1 * wave).cast<float>();
      point.r = point.g = point.b = static_cast<unsigned char> (128 + 100 * wave);
    }

  pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGB> registration;
  registration.setInputSource (cloud);
  registration.setInputTarget (cloud);
  Cloud warped;
  registration.align (warped);
  const bool in_place = std::abs (warped (32, 24).z - (*cloud) (32, 24).z) < 1e-3f;
  return registration.hasConverged() && in_place ? 0 : 1;
}
