// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// One call: the motion of every point between two organized clouds.
#include <pcl/io/pcd_io.h>

#include "example_clouds.h"
#include <pcl_msf/register_clouds.h>

#include <iostream>

int
main (int argc, char** argv)
{
  Cloud::Ptr reference = exampleCloud (0);
  Cloud::Ptr current = exampleCloud (1);
  if (argc == 3 && (pcl::io::loadPCDFile (argv[1], *reference) < 0 ||
                    pcl::io::loadPCDFile (argv[2], *current) < 0))
    return 1;

  const auto result = pcl_msf::registerClouds (reference, current);
  if (!result.converged)
    return 1; // the reason is on stderr and in result.scene_flow.report.message

  std::cout << result.scene_flow.segments.size() << " segments, "
            << result.scene_flow.groups << " motion groups; the largest moves by\n"
            << result.scene_flow.dominant_motion.matrix() << "\n";
  const auto& p = (*reference) (80, 60);
  const auto& q = result.warped (80, 60); // organized like the reference
  std::cout << "the middle point moves by " << q.x - p.x << " " << q.y - p.y << " "
            << q.z - p.z << " m\n";
  return 0;
}
