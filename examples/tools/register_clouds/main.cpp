// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Registers two organized clouds and saves the first one carried to the second.
#include <pcl/io/pcd_io.h>

#include "common/command_line.h"
#include "common/depth_check.h"
#include "common/input_files.h"
#include "common/interruption.h"
#include "common/tool_main.h"
#include "io/base/classic_locale.h"
#include "io/base/input_file.h"
#include "io/base/output_file.h"
#include <CLI/App.hpp>
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <tuple>
#include <vector>

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

/** Does the file begin as a .pcd does? An empty one holds nothing to lose. */
bool
isPcdOrEmpty (const std::string& path)
{
  std::ifstream file (path, std::ios::binary);
  const std::string mark = "\xEF\xBB\xBF"; // of UTF-8
  bool empty = true;
  for (std::string line; std::getline (file, line); empty = false) {
    if (empty && line.rfind (mark, 0) == 0)
      line.erase (0, mark.size());
    if (!line.empty() && line.front() != '#' && line != "\r")
      return line.rfind ("VERSION", 0) == 0 || line.rfind ("FIELDS", 0) == 0;
  }
  return empty;
}

void
checkOutput (const RegisterOptions& o)
{
  InputFiles inputs;
  inputs.add (o.reference);
  inputs.add (o.current);
  requireNoInput ("WARPED", o.warped, inputs);
  const std::string quoted = "WARPED: '" + o.warped + "' ";
  if (io::lowerExtension (o.warped) != ".pcd")
    throw UsageError (quoted + "does not end in .pcd, which is written; give a name "
                               "that does");
  if (std::filesystem::is_directory (o.warped))
    throw UsageError (quoted + "is a folder; give a file");
  if (std::filesystem::exists (o.warped) && !isPcdOrEmpty (o.warped))
    throw UsageError (quoted + "is there and no .pcd file; give another name");
}

/** What the registration would refuse, by files' names and with this tool's remedies.
 */
void
checkClouds (const RegisterOptions& o, const std::vector<Cloud::Ptr>& clouds)
{
  const auto size = [] (const Cloud& cloud) {
    return std::to_string (cloud.width) + "x" + std::to_string (cloud.height);
  };
  if (size (*clouds[0]) != size (*clouds[1]))
    throw InvalidInput (o.reference + " has " + size (*clouds[0]) + " points, " +
                        o.current + " " + size (*clouds[1]) +
                        "; give clouds of one size");
  PinholeCamera camera;
  std::string why;
  if (!estimateCamera (coordinateImage (*clouds[0]), camera, &why))
    throw InvalidInput (o.reference + ": camera: " + why);
  if (!fitsCamera (coordinateImage (*clouds[1]), camera, &why))
    throw InvalidInput (o.current + ": not of the camera of " + o.reference + ": " +
                        why);
  for (const auto& [path, cloud] :
       {std::tie (o.reference, clouds[0]), std::tie (o.current, clouds[1])}) {
    const std::string problem = checkDepth (
        depthImage (pointImage (*cloud)), {}, path, {std::nullopt, false, false});
    if (!problem.empty())
      complain (kProgram, "warning: " + problem);
    if (cloud->front().a == 0)
      complain (kProgram, "warning: " + path + ": no colour found: geometry alone");
  }
}

int
run (const RegisterOptions& o)
{
  checkOutput (o);
  const auto clouds = io::readOrganizedClouds ({o.reference, o.current});
  checkClouds (o, clouds);
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
