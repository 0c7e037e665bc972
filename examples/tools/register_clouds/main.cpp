// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_io.h>

#include <pcl_msf/piecewise_rigid_registration.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

/** Registers two organized clouds and saves the first one carried to the second. */
int
main (int argc, char** argv)
{
  using Cloud = pcl::PointCloud<pcl::PointXYZRGBA>;
  const auto reference = pcl::make_shared<Cloud>();
  const auto current = pcl::make_shared<Cloud>();
  const std::string first = argc > 1 ? argv[1] : "";
  const bool help = first == "--help" || first == "-h";
  std::error_code none;
  for (int i = 1; argc == 4 && i < 3; ++i)
    if (std::filesystem::equivalent (argv[i], argv[3], none)) {
      std::cerr << argv[3] << " is the input " << argv[i] << "; give another name\n";
      return 2;
    }
  if (argc != 4 || pcl::io::loadPCDFile (argv[1], *reference) < 0 ||
      pcl::io::loadPCDFile (argv[2], *current) < 0) {
    (help ? std::cout : std::cerr)
        << "usage: pcl_msf_register_clouds REFERENCE.pcd CURRENT.pcd WARPED.pcd\n";
    return help ? 0 : 2;
  }

  pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGBA> registration;
  registration.setInputSource (reference);
  registration.setInputTarget (current);
  Cloud warped;
  registration.align (warped);
  if (!registration.hasConverged())
    return 1; // the reason is on stderr and in getReport ().message

  std::cout << registration.getSceneFlow().bodies << " motion groups, dominant motion\n"
            << registration.getFinalTransformation() << "\nmean squared distance "
            << registration.getFitnessScore() << " m^2\n";
  return pcl::io::savePCDFileBinary (argv[3], warped) == 0 ? 0 : 1;
}
