// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/box_chain.h"
#include "support/run_tool.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/point_files.h>

#include <algorithm>
#include <sstream>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

const std::string kTool = std::string (PCL_MSF_TOOLS "/pcl_msf_register") + " ";

TEST (RegisterTool, WritesWhatAUserWants)
{
  const TemporaryFolder folder;
  const BoxChain chain;
  const ChainCloud source = drawChain (chain, 3000, false, 1);
  const ChainCloud target = drawChain (chain, 3000, true, 2);
  io::writePointsPly (folder ("source.ply"), source.points);
  std::ostringstream obj;
  obj << "# vertices\n";
  for (const auto& p : target.points)
    obj << "v " << p.x() << " " << p.y() << " " << p.z() << "\n";
  obj << "f 1 2 3\n";
  writeFile (folder ("target.obj"), obj.str());
  const ToolRun done =
      runTool (folder,
               kTool + folder ("source.ply") + " " + folder ("target.obj") +
                   " --threads 2 --output " + folder ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_THAT (done.out, HasSubstr ("3000 points"));
  EXPECT_TRUE (done.err.empty()) << done.err;
  const io::PointFile warped = io::readPoints (folder ("out/warped.ply"));
  ASSERT_EQ (warped.points.size(), source.points.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < source.points.size(); ++i)
    sum += (warped.points[i].cast<double>() -
            chain.pose (source.box[i]) * source.rest[i].cast<double>())
               .norm();
  EXPECT_LT (sum / 3000.0, 3e-3);
  EXPECT_EQ (io::readPoints (folder ("out/registered.pcd")).points, warped.points);
  const std::string parts = readFile (folder ("out/parts.txt"));
  EXPECT_EQ (std::count (parts.begin(), parts.end(), '\n'), 3000);
  EXPECT_THAT (readFile (folder ("out/joints.json")), HasSubstr ("\"angle_deg\""));
  EXPECT_THAT (readFile (folder ("out/report.json")),
               HasSubstr ("\"converged\": true"));
  EXPECT_THAT (readFile (folder ("out/report.json")), HasSubstr ("\"tuning_hash\""));
  EXPECT_EQ (filesIn (folder ("out")), 6u); // with the list of them
}

TEST (RegisterTool, RefusesInOneLine)
{
  const TemporaryFolder folder;
  io::writePointsPly (folder ("few.ply"),
                      std::vector<Eigen::Vector3f> (3, Eigen::Vector3f::Ones()));
  const std::string few = folder ("few.ply");
  const std::string output = " --output " + folder ("out");
  for (const std::string& arguments :
       {few + output,             // no target
        few + " " + few,          // no output
        few + " " + few + output, // too few points
        few + " " + folder ("none.ply") + output,
        few + " " + few + " " + few + output, // a word too many
        few + " " + few + output + " --threads x",
        few + " " + few + output + " --tuning points.luck=1",
        few + " " + few + output + " --tuning points.match.isotropy=2",
        few + " " + few + output + " --tuning points.match.isotropy"}) {
    const ToolRun refused = runTool (folder, kTool + arguments);
    EXPECT_EQ (refused.status, 1) << arguments;
    EXPECT_EQ (refused.errorLines(), 1) << refused.err;
  }
  EXPECT_EQ (runTool (folder, kTool + "--help").status, 0);
}

TEST (RegisterTool, ListsTunedValuesButNotInItsHelp)
{
  const TemporaryFolder folder;
  const ToolRun list =
      runTool (folder, kTool + "--tuning points.match.isotropy=0.25 --list-tuning");
  EXPECT_EQ (list.status, 0) << list.err;
  EXPECT_THAT (list.out, HasSubstr ("points.match.isotropy 0.25 0 1 real\n"));
  EXPECT_THAT (runTool (folder, kTool + "--help").out,
               ::testing::Not (HasSubstr ("tuning")));
}

} // namespace
