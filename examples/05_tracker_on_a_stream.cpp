// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Clouds that come one by one, as from a grabber; memory does not grow.
#include "example_clouds.h"
#include <pcl_msf/piecewise_rigid_tracker.h>

#include <functional>
#include <iostream>

int
main ()
{
  pcl_msf::PiecewiseRigidTracker<pcl::PointXYZRGBA> tracker;
  pcl_msf::TrackerParameters parameters;
  parameters.window = 3;
  tracker.setTrackerParameters (parameters);

  int known = 0;
  // With a sensor: grabber.registerCallback (callback); grabber.start ();
  const std::function<void (const Cloud::ConstPtr&)> callback =
      [&] (const Cloud::ConstPtr& cloud) {
        if (!tracker.addCloud (cloud) || !tracker.getSceneFlow().report.converged)
          return; // the reason is on stderr; the next cloud is welcome
        ++known;
        std::cout << "since cloud " << tracker.getReferenceIndex() << ": "
                  << tracker.getSceneFlow().bodies << " motion groups, camera at "
                  << tracker.getCameraPose().topRightCorner<3, 1>().transpose()
                  << " m\n";
      };
  for (int frame = 0; frame < 4; ++frame)
    callback (exampleCloud (frame));
  return known == 3 ? 0 : 1;
}
