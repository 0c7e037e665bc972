// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Registers two organized clouds and saves the first one carried to the second.
#include <pcl/io/pcd_io.h>

#include "common/command_line.h"
#include "common/input_files.h"
#include "common/interruption.h"
#include "common/tool_main.h"
#include "io/base/classic_locale.h"
#include "io/base/output_file.h"
#include <CLI/App.hpp>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <iostream>
#include <tuple>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_register_clouds";

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

void
save (const std::string& path, const Cloud& cloud)
{
  io::writeThenRename (path, [&cloud] (const std::string& temporary) {
    const io::ClassicLocale classic;
    pcl::PCDWriter().writeBinary (temporary, cloud);
  });
}

int
run (const RegisterOptions& o)
{
  InputFiles inputs;
  inputs.add (o.reference);
  inputs.add (o.current);
  requireNoInput ("WARPED", o.warped, inputs);
  const auto clouds = io::readOrganizedClouds ({o.reference, o.current});
  for (const auto& [path, cloud] :
       {std::tie (o.reference, clouds[0]), std::tie (o.current, clouds[1])})
    if (cloud->front().a == 0)
      complain (kProgram, "warning: " + path + ": no colour found: geometry alone");
  PiecewiseRigidRegistration<pcl::PointXYZRGBA> registration;
  registration.setInputSource (clouds[0]);
  registration.setInputTarget (clouds[1]);
  SolverParameters solver;
  solver.progress = [] (const Progress&) { return !interrupted(); };
  registration.setSolverParameters (solver);
  Cloud warped;
  registration.align (warped);
  throwIfInterrupted();
  if (!registration.hasConverged())
    throw InvalidInput (registration.getReport().message);
  std::cout << registration.getSceneFlow().groups << " motion groups, dominant motion\n"
            << registration.getFinalTransformation() << "\nmean squared distance "
            << registration.getFitnessScore() << " m^2\n";
  save (o.warped, warped);
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<RegisterOptions> (
      {kProgram,
       "Registers two organized clouds and saves the first one carried to the second.",
       declareOptions,
       run},
      argc,
      argv);
}
