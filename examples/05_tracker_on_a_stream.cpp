// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Clouds that come one by one, as from a grabber; memory does not grow.
#include "example_clouds.h"
#include <pcl_msf/frame_queue.h>
#include <pcl_msf/piecewise_rigid_tracker.h>

#include <iostream>
#include <thread>

int
main ()
{
  pcl_msf::PiecewiseRigidTracker<pcl::PointXYZRGBA> tracker;
  pcl_msf::FrameParameters frames;
  frames.finest_level = 1; // solved at half the clouds' size: three times as fast
  tracker.setFrameParameters (frames);

  // A sensor's thread fills the queue and is never kept waiting: its callback calls
  // queue.push (cloud), which drops the oldest cloud when the tracker is slower.
  pcl_msf::FrameQueue<Cloud::ConstPtr> queue;
  std::thread sensor ([&queue] {
    for (int frame = 0; frame < 4; ++frame)
      queue.pushWhenThereIsRoom (exampleCloud (frame)); // here all are wanted
    queue.close();
  });

  int known = 0;
  while (const auto cloud = queue.pop()) {
    if (!tracker.addCloud (*cloud) || !tracker.getSceneFlow().report.converged)
      continue; // the reason is on stderr; the next cloud is welcome
    ++known;
    std::cout << "since cloud " << tracker.getReferenceIndex() << ": "
              << tracker.getSceneFlow().groups << " motion groups, camera at "
              << tracker.getCameraPose().topRightCorner<3, 1>().transpose() << " m\n";
  }
  sensor.join();
  return known == 3 ? 0 : 1;
}
