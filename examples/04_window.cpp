// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Several frames solved jointly: more evidence for each of them.
#include "example_clouds.h"
#include <pcl_msf/piecewise_rigid_registration.h>

#include <iostream>

int
main ()
{
  pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGBA> registration;
  registration.setInputSource (exampleCloud (0));
  registration.setInputTargets ({exampleCloud (1), exampleCloud (2), exampleCloud (3)});

  pcl_msf::MultiframeParameters parameters;
  parameters.max_span = 2; // leave out pairs of frames that are farther apart
  registration.setMultiframeParameters (parameters);

  Cloud warped; // to the last frame
  registration.align (warped);
  if (!registration.hasConverged())
    return 1;
  for (int frame = 1; frame < 4; ++frame) {
    const pcl_msf::SceneFlow& flow = registration.getSceneFlow (frame);
    const Cloud at_frame = registration.getWarpedCloud (frame);
    std::cout << "frame " << frame << ": the middle point is at "
              << at_frame (80, 60).getVector3fMap().transpose() << ", the camera's "
              << "motion is\n"
              << flow.dominant_motion.inverse().matrix() << "\n";
  }
  std::cout << "segment 0 from frame 1 to 3:\n"
            << registration.getPose (1, 3, 0) << "\n";
  return 0;
}
