// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Registers two organized clouds and saves the first one carried to the second.
#include <pcl/io/pcd_io.h>

#include "common/command_line.h"
#include "common/input_files.h"
#include "common/tool_main.h"
#include <CLI/App.hpp>
#include <pcl_msf/errors.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <iostream>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using Cloud = pcl::PointCloud<pcl::PointXYZRGBA>;

struct RegisterOptions {
  std::string reference;
  std::string current;
  std::string warped;
};

void
declareOptions (CLI::App& app, RegisterOptions& o)
{
  addText (app, "REFERENCE", "FILE.pcd", "an organized cloud", o.reference)->required();
  addText (app, "CURRENT", "FILE.pcd", "one of the same size", o.current)->required();
  addText (app, "WARPED", "FILE.pcd", "the first carried to the second", o.warped)
      ->required();
}

Cloud::Ptr
load (const std::string& path)
{
  const auto cloud = pcl::make_shared<Cloud>();
  if (pcl::io::loadPCDFile (path, *cloud) < 0)
    throw IoError (path + ": cannot be read as .pcd; check the path and the format");
  return cloud;
}

int
run (const RegisterOptions& o)
{
  InputFiles inputs;
  inputs.add (o.reference);
  inputs.add (o.current);
  requireNoInput ("WARPED", o.warped, inputs);
  PiecewiseRigidRegistration<pcl::PointXYZRGBA> registration;
  registration.setInputSource (load (o.reference));
  registration.setInputTarget (load (o.current));
  Cloud warped;
  registration.align (warped);
  if (!registration.hasConverged())
    throw InvalidInput (registration.getReport().message);
  std::cout << registration.getSceneFlow().groups << " motion groups, dominant motion\n"
            << registration.getFinalTransformation() << "\nmean squared distance "
            << registration.getFitnessScore() << " m^2\n";
  if (pcl::io::savePCDFileBinary (o.warped, warped) != 0)
    throw IoError (o.warped + ": cannot be written; check the folder");
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<RegisterOptions> (
      {"pcl_msf_register_clouds",
       "Registers two organized clouds and saves the first one carried to the second.",
       declareOptions,
       run},
      argc,
      argv);
}
