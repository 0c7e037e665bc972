// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include "support/box_chain.h"
#include "support/expect_refusal.h"
#include "support/run_tool.h"
#include "support/slid_clouds.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/point_files.h>

#include <algorithm>
#include <array>
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

void
writeColoredPly (const std::string& path,
                 const std::vector<Eigen::Vector3f>& points,
                 const std::vector<float>& brightness)
{
  std::ostringstream ply;
  ply << "ply\nformat ascii 1.0\nelement vertex " << points.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
         "red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int b = static_cast<int> (255.0F * brightness[i]);
    ply << points[i].transpose() << " " << b << " " << b << " " << b << "\n";
  }
  writeFile (path, ply.str());
}

TEST (RegisterTool, ColoursTellWhatSlidesWithinItsSurface)
{
  const TemporaryFolder folder;
  const SlidClouds clouds = turnedCylinder (0.3);
  writeColoredPly (folder ("source.ply"), clouds.source, clouds.source_brightness);
  writeColoredPly (folder ("target.ply"), clouds.target, clouds.target_brightness);
  const std::string command = kTool + folder ("source.ply") + " " +
                              folder ("target.ply") + " --quiet --output " +
                              folder ("out");
  const ToolRun done = runTool (folder, command);
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_LT (clouds.meanError (io::readPoints (folder ("out/warped.ply")).points),
             4e-3);
  ASSERT_EQ (runTool (folder, command + " --brightness-weight 0").status, 0);
  EXPECT_GT (clouds.meanError (io::readPoints (folder ("out/warped.ply")).points),
             0.03);
  const ToolRun refused = runTool (folder, command + " --brightness-weight -1");
  EXPECT_EQ (refused.status, 1);
  EXPECT_THAT (refused.err, HasSubstr ("--brightness-weight"));
}

TEST (RegisterTool, TakesSegmentsAndKnownPairs)
{
  const TemporaryFolder folder;
  BoxChain box; // turned by nearly half a turn: it looks as if it had hardly moved
  box.boxes = 1;
  box.root = RigidPose{{0.0, 0.0, 3.0, 0.3, 0.02, 0.01}};
  const ChainCloud source = drawChain (box, 2000, false, 3);
  ChainCloud target = drawChain (box, 2000, true, 4);
  std::string labels;
  std::string pairs = "# source target weight\n";
  for (int i = 0; i < 2000; ++i) {
    labels += i % 100 == 0 ? "-1\n" : "7\n";
    if (i % 500 != 1)
      continue;
    pairs += std::to_string (i) + " " + std::to_string (target.points.size()) + " 2\n";
    target.points.push_back ((box.root * source.rest[i].cast<double>()).cast<float>());
  }
  io::writePointsPly (folder ("source.ply"), source.points);
  io::writePointsPly (folder ("target.ply"), target.points);
  writeFile (folder ("labels.txt"), labels);
  writeFile (folder ("pairs.txt"), pairs);
  const std::string command = kTool + folder ("source.ply") + " " +
                              folder ("target.ply") + " --quiet --output " +
                              folder ("out");
  const ToolRun done = runTool (folder,
                                command + " --segments " + folder ("labels.txt") +
                                    " --pairs " + folder ("pairs.txt"));
  ASSERT_EQ (done.status, 0) << done.err;
  const io::PointFile warped = io::readPoints (folder ("out/warped.ply"));
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d truth = box.root * source.rest[i].cast<double>();
    ASSERT_EQ (warped.points[i].allFinite(), i % 100 != 0);
    ASSERT_TRUE (i % 100 == 0 ||
                 (warped.points[i].cast<double>() - truth).norm() < 5e-3);
  }
  writeFile (folder ("pairs.txt"), "1 2\n3\n");
  const ToolRun refused =
      runTool (folder, command + " --pairs " + folder ("pairs.txt"));
  EXPECT_EQ (refused.status, 1);
  EXPECT_THAT (refused.err, HasSubstr ("line 2"));
}

/** Colours in three fields, coordinates as doubles: PCL's own reader drops both. */
void
writeDialect (const std::string& path, const io::DataFolder& frames, int frame)
{
  const io::RgbdImages images = frames.frame (frame);
  const cv::Size size = images.depth.size();
  const auto number = [] (double value) {
    return std::string (reinterpret_cast<const char*> (&value), sizeof value);
  };
  std::string text =
      "VERSION .7\nFIELDS x y z r g b\nSIZE 8 8 8 1 1 1\nTYPE F F F U U U\n"
      "COUNT 1 1 1 1 1 1\nWIDTH " +
      std::to_string (size.width) + "\nHEIGHT " + std::to_string (size.height) +
      "\nPOINTS " + std::to_string (size.area()) + "\nDATA binary\n";
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      const auto& color = images.color.at<cv::Vec3b> (v, u);
      const double z = images.depth.at<float> (v, u);
      text += number (z * (u - images.camera.cx) / images.camera.fx) +
              number (z * (v - images.camera.cy) / images.camera.fy) + number (z);
      for (const int channel : {2, 1, 0})
        text += static_cast<char> (color[channel]);
    }
  writeFile (path, text);
}

class RegisterCloudsTool : public ::testing::Test {
protected:
  ToolRun
  run (const std::string& tool, const std::string& arguments) const
  {
    return runTool (folder_, PCL_MSF_TOOLS "/pcl_msf_" + tool + " " + arguments);
  }
  /** Two clouds. \return them as arguments */
  std::string
  writeClouds (const std::string& size) const
  {
    const std::string options = " --depth png --frames 2" + size;
    EXPECT_EQ (run ("synthesize", folder_ ("seq") + options).status, 0);
    const io::DataFolder frames (folder_ ("seq"));
    for (const int k : {0, 1})
      writeDialect (folder_ ("d" + std::to_string (k) + ".pcd"), frames, k);
    return folder_ ("d0.pcd") + " " + folder_ ("d1.pcd") + " ";
  }

  TemporaryFolder folder_;
};

TEST_F (RegisterCloudsTool, BodiesAreDrawnAndFoundAgain)
{
  const ToolRun drawn =
      run ("synthesize",
           folder_ ("body") + " --body animal --points 3000 --angle 20 --noise 0.001");
  EXPECT_EQ (drawn.status, 0) << drawn.err;
  const ToolRun found =
      run ("register",
           folder_ ("body/source.ply") + " " + folder_ ("body/target.ply") +
               " --quiet --output " + folder_ ("result"));
  EXPECT_EQ (found.status, 0) << found.err;
  const auto truth = io::readPoints (folder_ ("body/truth.ply")).points;
  const auto warped = io::readPoints (folder_ ("result/warped.ply")).points;
  ASSERT_EQ (warped.size(), truth.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum += (warped[i] - truth[i]).norm();
  EXPECT_LT (sum / static_cast<double> (truth.size()), 0.01);
  const ToolRun refused = run ("synthesize", folder_ ("no") + " --body animal --cut 2");
  EXPECT_EQ (refused.status, 1);
  EXPECT_THAT (refused.err, HasSubstr ("cut: must be in [0, 0.9]"));
}

TEST_F (RegisterCloudsTool, ReadsAnyDialectAndNamesWhatCannotBeWritten)
{
  const std::string clouds = writeClouds (" --width 160 --height 120");
  const ToolRun done = run ("register_clouds", clouds + folder_ ("warped.pcd"));
  EXPECT_EQ (done.status, 0);
  EXPECT_EQ (done.err, "");
  const auto warped = io::readOrganizedCloud (folder_ ("warped.pcd"));
  const cv::Vec3b color =
      io::DataFolder (folder_ ("seq")).frame (0).color.at<cv::Vec3b> (7, 7);
  EXPECT_EQ ((*warped) (7, 7).r, color[2]);
  EXPECT_EQ ((*warped) (7, 7).b, color[0]);
  const std::string nowhere = clouds + folder_ ("no/such.pcd");
  expectRefusal (
      run ("register_clouds", nowhere), nowhere, {"such.pcd: cannot be written"});
}

TEST_F (RegisterCloudsTool, OverwritesCloudsAlone)
{
  const std::string clouds = writeClouds (" --width 160 --height 120");
  writeFile (folder_ ("notes.pcd"), "# mine\nand no cloud");
  writeFile (folder_ ("empty.pcd"), "");
  std::filesystem::create_directory (folder_ ("folder.pcd"));
  const std::vector<std::pair<std::string, std::string>> refused{
      {"w.ply", "does not end in .pcd"},
      {"w", "does not end in .pcd"},
      {"notes.pcd", "is there and no .pcd file"},
      {"folder.pcd", "is a folder"}};
  for (const auto& [name, words] : refused)
    expectRefusal (run ("register_clouds", clouds + folder_ (name)),
                   name,
                   {"WARPED: '" + folder_ (name) + "' " + words});
  EXPECT_EQ (readFile (folder_ ("notes.pcd")), "# mine\nand no cloud");
  for (const char* name : {"empty.pcd", "empty.pcd", "new.PCD"})
    EXPECT_EQ (run ("register_clouds", clouds + folder_ (name)).status, 0) << name;
}

TEST_F (RegisterCloudsTool, NamesTheFileThatIsNoCamerasInMetres)
{
  const std::string clouds = writeClouds (" --width 160 --height 120");
  const auto cloud = io::readOrganizedCloud (folder_ ("d0.pcd"));
  auto millimetres = *cloud, turned = *cloud, small = *cloud;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const auto& p = (*cloud)[i];
    millimetres[i].getVector3fMap() *= 1000.0F;
    turned[i].getVector3fMap() = Eigen::Vector3f (p.z, -p.x, -p.y);
  }
  small.resize (160 * 60);
  small.width = 160;
  small.height = 60;
  pcl::io::savePCDFileBinary (folder_ ("mm.pcd"), millimetres);
  pcl::io::savePCDFileBinary (folder_ ("turned.pcd"), turned);
  pcl::io::savePCDFileBinary (folder_ ("small.pcd"), small);
  const std::vector<std::array<std::string, 3>> refused{
      {"mm.pcd", "mm.pcd", "mm.pcd: depth is "},
      {"mm.pcd", "mm.pcd", "give metres (millimetres?)"},
      {"turned.pcd", "d1.pcd", "turned.pcd: camera: "},
      {"d0.pcd", "turned.pcd", "turned.pcd: not of the camera of "},
      {"d0.pcd", "small.pcd", "small.pcd 160x60; give clouds of one size"}};
  for (const auto& [reference, current, words] : refused) {
    const ToolRun done =
        run ("register_clouds",
             folder_ (reference) + " " + folder_ (current) + " " + folder_ ("w.pcd"));
    expectRefusal (done, reference + " " + current, {words});
    for (const char* foreign : {"min_depth", "--depth-scale", "setCamera"})
      EXPECT_THAT (done.err, ::testing::Not (HasSubstr (foreign)));
  }
}

TEST_F (RegisterCloudsTool, EndsOnASignal)
{
  const std::string clouds = writeClouds (" --width 640 --height 480");
  // SIGTERM is bit 14 of the mask of signals that are noted.
  const ToolRun ended = runTool (
      folder_,
      "{ " PCL_MSF_TOOLS "/pcl_msf_register_clouds " + clouds + folder_ ("warped.pcd") +
          " & p=$!; until grep -q 'SigCgt:.*[4-7c-f]...$' /proc/$p/status || "
          "! kill -0 $p; do sleep 0.01; done; kill -TERM $p; wait $p; }");
  EXPECT_EQ (ended.status, 128 + 15) << ended.err;
  EXPECT_EQ (ended.errorLines(), 1) << ended.err;
  EXPECT_FALSE (std::filesystem::exists (folder_ ("warped.pcd")));
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
        few + " " + few + " " + few + output, // several targets
        few + " " + few + output + " --threads x",
        few + " " + few + output + " --tuning points.luck=1",
        few + " " + few + output + " --tuning points.match.isotropy=2",
        few + " " + few + output + " --tuning points.match.isotropy"}) {
    expectRefusal (runTool (folder, kTool + arguments), arguments);
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
