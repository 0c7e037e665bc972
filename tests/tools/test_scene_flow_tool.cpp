// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/expect_refusal.h"
#include "support/small_scene.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/point_types.h>

#include <cmath>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kTool = PCL_MSF_TOOLS "/pcl_msf_scene_flow";

class SceneFlowTool : public ::testing::Test {
protected:
  std::string
  imageArguments () const
  {
    return " --color " + folder_ ("c0.png") + " --depth " + folder_ ("d0.png") +
           " --color " + folder_ ("c1.png") + " --depth " + folder_ ("d1.png") +
           " --camera 150,150,79.5,59.5 --depth-scale 5000";
  }
  ToolRun
  run (const std::string& arguments) const
  {
    return runTool (folder_, kTool + arguments);
  }
  std::string
  result (const std::string& name) const
  {
    return folder_ ("out/" + name);
  }
  void
  expectRefusal (const std::string& arguments, const std::string& words) const
  {
    const ToolRun refused = run (arguments);
    pcl_msf::testing::expectRefusal (refused, arguments, {words});
    EXPECT_EQ (refused.out, "");
    EXPECT_FALSE (std::filesystem::exists (result ("report.json"))) << arguments;
  }

  TemporaryFolder folder_;
  SmallScene scene_;
};

/** Checks what only this scene can tell: the box moved, the wall did not. */
void
checkFlow (const cv::Mat& flow)
{
  ASSERT_EQ (flow.size(), cv::Size (SmallScene::kWidth, SmallScene::kHeight));
  const cv::Vec2f box = flow.at<cv::Vec2f> (65, 75);
  const cv::Vec2f wall = flow.at<cv::Vec2f> (20, 130);
  EXPECT_NEAR (box[0], SmallScene::kBoxShift, 0.5);
  EXPECT_NEAR (box[1], 0.0, 0.5);
  EXPECT_NEAR (cv::norm (wall), 0.0, 0.5);
  EXPECT_TRUE (std::isnan (flow.at<cv::Vec2f> (2, 2)[0])) << "no depth";
}

void
checkClouds (const std::string& scene_flow, const std::string& warped)
{
  pcl::PointCloud<PointXYZRGBFlow> cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (scene_flow, cloud), 0);
  ASSERT_EQ (cloud.width, unsigned{SmallScene::kWidth});
  ASSERT_EQ (cloud.height, unsigned{SmallScene::kHeight});
  EXPECT_NEAR (cloud (75, 65).z, 1.0, 1e-3);
  EXPECT_NEAR (cloud (75, 65).dx, SmallScene::kBoxShift / 150.0, 0.004);
  EXPECT_TRUE (std::isnan (cloud (2, 2).x) && std::isnan (cloud (2, 2).dx));
  EXPECT_NE (cloud (75, 65).label, cloud (130, 20).label);
  EXPECT_GT (cloud (75, 65).flow_deviation, 0.0F);
  EXPECT_GT (cloud (75, 65).displacement_deviation, 0.0F);
  EXPECT_TRUE (std::isnan (cloud (2, 2).flow_deviation));
  pcl::PointCloud<pcl::PointXYZRGB> moved;
  ASSERT_EQ (pcl::io::loadPCDFile (warped, moved), 0);
  ASSERT_TRUE (moved.isOrganized());
  EXPECT_FLOAT_EQ (moved (75, 65).x, cloud (75, 65).x + cloud (75, 65).dx);
}

void
checkReport (const std::string& path)
{
  const cv::FileStorage report (path,
                                cv::FileStorage::READ | cv::FileStorage::FORMAT_JSON);
  ASSERT_TRUE (report.isOpened());
  EXPECT_EQ (static_cast<int> (report["frames"]), 2);
  EXPECT_GT (static_cast<double> (report["median_flow_deviation_px"]), 0.0);
  EXPECT_EQ (report["dominant_motion_information"].size(), 6U);
  EXPECT_EQ (readFile (path).find ("null"), std::string::npos);
  EXPECT_EQ (static_cast<int> (report["width"]), SmallScene::kWidth);
  EXPECT_EQ (static_cast<int> (report["height"]), SmallScene::kHeight);
  EXPECT_GE (static_cast<int> (report["segments"]), 2);
  for (const char* key : {"iterations", "converged", "stop_reason", "message"})
    EXPECT_FALSE (report[key].empty()) << key;
  for (const char* key :
       {"total", "load", "frame", "segment", "start", "solve", "result", "write"})
    EXPECT_TRUE (report["seconds"][key].isReal() || report["seconds"][key].isInt())
        << key;
  EXPECT_GT (static_cast<double> (report["seconds"]["total"]),
             static_cast<double> (report["seconds"]["load"]));
  EXPECT_FALSE (report["cost"]["initial"].empty());
  EXPECT_FALSE (report["cost"]["final"].empty());
  for (const char* term : {"brightness", "icp", "regularizer", "prior"})
    EXPECT_FALSE (report["cost"]["per_term"][term]["final"].empty()) << term;
  EXPECT_EQ (report["dominant_motion"].size(), 4U);
}

TEST_F (SceneFlowTool, ACoveredLensIsNoSuccess)
{
  scene_.writeImages (folder_);
  const cv::Size size (SmallScene::kWidth, SmallScene::kHeight);
  io::writeImage (folder_ ("c1.png"), cv::Mat (size, CV_8UC3, cv::Scalar::all (20.0)));
  io::writeDepth (
      folder_ ("d1.png"), cv::Mat (size, CV_32FC1, cv::Scalar (0.3)), 5000.0);
  const ToolRun done = run (imageArguments() + " --output " + folder_ ("out"));
  EXPECT_EQ (done.status, 3);
  EXPECT_EQ (done.errorLines(), 1) << done.err;
  EXPECT_THAT (done.err, HasSubstr ("not converged (nothing_determined)"));
  EXPECT_THAT (done.out, HasSubstr ("nothing_determined"));
  const std::string report = readFile (result ("report.json"));
  EXPECT_THAT (report, HasSubstr ("\"converged\": false"));
  EXPECT_THAT (report, HasSubstr ("\"stop_reason\": \"nothing_determined\""));
  EXPECT_TRUE (std::filesystem::exists (result ("flow_0_1.flo")));
}

TEST_F (SceneFlowTool, WritesEverythingFromImages)
{
  scene_.writeImages (folder_);
  const ToolRun done = run (imageArguments() + " --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_LE (done.errorLines(), 1) << done.err;
  EXPECT_THAT (done.out, HasSubstr ("segments"));
  checkFlow (io::readFlow (result ("flow_0_1.flo")));
  checkClouds (result ("scene_flow_0_1.pcd"), result ("warped_0_1.pcd"));
  checkReport (result ("report.json"));
  EXPECT_EQ (cv::imread (result ("labels_0.png"), cv::IMREAD_UNCHANGED).type(),
             CV_16UC1);
  const cv::Mat visible = cv::imread (result ("visible_0_1.png"), cv::IMREAD_UNCHANGED);
  ASSERT_EQ (visible.type(), CV_8UC1);
  EXPECT_EQ (visible.at<unsigned char> (65, 75), 255);
  EXPECT_EQ (visible.at<unsigned char> (2, 2), 0);
  EXPECT_EQ (cv::countNonZero (visible), cv::countNonZero (visible == 255));
  for (const char* name : {"flow_0_1.png",
                           "segments_0.png",
                           "motions_0.png",
                           "residual_0_1.png",
                           "deviation_0_1.png"})
    EXPECT_EQ (cv::imread (result (name)).cols, int{SmallScene::kWidth}) << name;
  for (const auto& entry : std::filesystem::directory_iterator (folder_ ("out")))
    EXPECT_NE (entry.path().extension(), ".part");
}

TEST_F (SceneFlowTool, WritesTheSameFromClouds)
{
  scene_.writeClouds (folder_);
  const ToolRun done =
      run (" --quiet --cloud " + folder_ ("k0.pcd") + " --cloud=" + folder_ ("k1.pcd") +
           " --output " + folder_ ("new/out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_EQ (done.out, "") << "--quiet";
  checkFlow (io::readFlow (folder_ ("new/out/flow_0_1.flo")));
  for (const char* name : {"scene_flow_0_1.pcd", "warped_0_1.pcd"})
    EXPECT_THAT (readFile (folder_ ("new/out/" + std::string (name))),
                 HasSubstr ("VIEWPOINT 1 0 0 1 0 0 0\n"))
        << "the reference's";
}

TEST_F (SceneFlowTool, TakesLabelsFromOutsideAndGeometryAlone)
{
  scene_.writeImages (folder_);
  cv::Mat labels (SmallScene::kHeight, SmallScene::kWidth, CV_32SC1, cv::Scalar (7));
  labels (cv::Rect (50, 40, 50, 50)).setTo (3);
  io::writeLabels (folder_ ("l.png"), labels);
  const ToolRun done =
      run (" --depth " + folder_ ("d0.png") + " --depth " + folder_ ("d1.png") +
           " --camera 150,150,79.5,59.5 --depth-scale 5000 --labels " +
           folder_ ("l.png") + " --threads 1 --output " + folder_ ("out"));
  // All is written; geometry alone leaves surfaces that face the camera free to slide.
  ASSERT_EQ (done.status, 3) << done.err;
  EXPECT_THAT (done.err, HasSubstr ("nothing_determined"));
  const cv::Mat written = io::readLabels (result ("labels_0.png"));
  EXPECT_EQ (written.at<int> (65, 75), 0);
  EXPECT_EQ (written.at<int> (20, 130), 1);
  EXPECT_EQ (written.at<int> (2, 2), -1);
}

TEST_F (SceneFlowTool, HelpIsNoError)
{
  for (const char* option : {" -h", " --help"}) {
    const ToolRun help = run (option);
    EXPECT_EQ (help.status, 0);
    EXPECT_THAT (help.out, HasSubstr ("--brightness-weight"));
    EXPECT_EQ (help.err, "");
  }
  const ToolRun nothing = run ("");
  EXPECT_NE (nothing.status, 0);
  EXPECT_THAT (nothing.out, HasSubstr ("--camera"));
}

TEST_F (SceneFlowTool, RefusesCommandLinesInOneLine)
{
  scene_.writeImages (folder_);
  const std::string good = imageArguments() + " --output " + folder_ ("out");
  expectRefusal (good + " --colour x", "--colour: no such option");
  expectRefusal (good + " --camera 0,150,79.5,59.5", "--camera");
  expectRefusal (imageArguments(), "--output: missing");
}

TEST_F (SceneFlowTool, RefusesFilesInOneLine)
{
  scene_.writeImages (folder_);
  const std::string output = " --output " + folder_ ("out");
  const std::string camera = " --camera 150,150,79.5,59.5 --depth-scale 5000";
  const auto depths = [&] (const std::string& second) {
    return " --depth " + folder_ ("d0.png") + " --depth " + folder_ (second) + camera;
  };
  expectRefusal (depths ("none.png") + output, "none.png: no such file");
  writeFile (folder_ ("junk.png"), "this is no image, whatever its name says");
  expectRefusal (depths ("junk.png") + output, "junk.png");
  writeFile (folder_ ("cut.png"), readFile (folder_ ("d1.png")).substr (0, 200));
  expectRefusal (depths ("cut.png") + output, "cut.png");
  expectRefusal (depths ("c1.png") + output, "c1.png: depth");
  io::writeDepth (folder_ ("small.png"), cv::Mat (60, 80, CV_32FC1, 1.0), 5000.0);
  expectRefusal (depths ("small.png") + output, "--depth: ");
  io::writeDepth (folder_ ("d0.png"), SmallScene::depth (0) * 0.0, 5000.0);
  expectRefusal (depths ("d1.png") + output, "depth");
  expectRefusal (" --cloud a.pcd --cloud b.pcd" + output, "a.pcd: no such file");
  writeFile (folder_ ("file"), "");
  expectRefusal (depths ("d1.png") + " --output " + folder_ ("file/out"), "file/out");
}

TEST_F (SceneFlowTool, SaysWhatDepthAWrongScaleMakes)
{
  scene_.writeImages (folder_);
  const std::string depths = " --depth " + folder_ ("d0.png") + " --depth " +
                             folder_ ("d1.png") + " --camera 150,150,79.5,59.5" +
                             " --output " + folder_ ("out") + " --depth-scale ";
  expectRefusal (
      depths + "0.001",
      "d0.png: depth is 5000000 to 10000000 m with --depth-scale 0.001; give "
      "units per metre, for example 1000");
  for (const int k : {0, 1})
    cv::imwrite (folder_ ("mm" + std::to_string (k) + ".tiff"),
                 cv::Mat (SmallScene::depth (k) * 400.0));
  const std::string floats = " --quiet --depth " + folder_ ("mm0.tiff") + " --depth " +
                             folder_ ("mm1.tiff") + " --camera 150,150,79.5,59.5" +
                             " --output " + folder_ ("out");
  const ToolRun warned = run (floats);
  EXPECT_THAT (
      warned.err,
      HasSubstr ("mm0.tiff: depth is 400 to 800 m; give --depth-scale, units per "
                 "metre, for example 1000"));
  const ToolRun scaled = run (floats + " --depth-scale 400");
  ASSERT_EQ (scaled.status, 3) << scaled.err; // parallel planes may slide
  EXPECT_THAT (scaled.err, HasSubstr ("not converged (nothing_determined)"));
  EXPECT_THAT (scaled.err, Not (HasSubstr ("depth is")));
  pcl::PointCloud<PointXYZRGBFlow> cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (result ("scene_flow_0_1.pcd"), cloud), 0);
  EXPECT_NEAR (cloud (75, 65).z, 1.0, 1e-3);
}

TEST_F (SceneFlowTool, SaysOnceThatCloudsHaveNoColour)
{
  scene_.writeClouds (folder_);
  pcl::PointCloud<pcl::PointXYZ> bare;
  ASSERT_EQ (pcl::io::loadPCDFile (folder_ ("k1.pcd"), bare), 0);
  pcl::io::savePCDFileBinary (folder_ ("bare.pcd"), bare);
  const std::string first = " --quiet --cloud " + folder_ ("k0.pcd") + " --cloud ";
  const ToolRun done =
      run (first + folder_ ("bare.pcd") + " --output " + folder_ ("out"));
  EXPECT_EQ (done.err.find ("warning: "),
             done.err.find ("warning: " + folder_ ("bare")));
  EXPECT_EQ (done.err.find ("geometry alone"), done.err.rfind ("geometry alone"));
  EXPECT_THAT (done.err,
               HasSubstr ("bare.pcd: no colour found (fields x y z): geometry alone"));
}

TEST_F (SceneFlowTool, EndsCleanlyOnASignal)
{
  scene_.writeImages (folder_);
  std::string arguments = imageArguments() + " --output " + folder_ ("out");
  for (int i = 0; i < 10; ++i) // a window that takes much longer than the signal
    arguments += " --color " + folder_ ("c0.png") + " --depth " + folder_ ("d0.png") +
                 " --color " + folder_ ("c1.png") + " --depth " + folder_ ("d1.png");
  // The folder is made once signals are noted.
  const ToolRun ended = runTool (
      folder_,
      "{ " + kTool + arguments + " & p=$!; until [ -d " + folder_ ("out") +
          " ] || ! kill -0 $p; do sleep 0.01; done; kill -TERM $p; wait $p; }");
  EXPECT_EQ (ended.status, 128 + 15) << ended.err;
  EXPECT_EQ (ended.errorLines(), 1) << ended.err;
  EXPECT_THAT (ended.err, HasSubstr ("interrupted"));
  EXPECT_FALSE (std::filesystem::exists (result ("report.json")));
}

TEST_F (SceneFlowTool, GivesEveryPixelsFlowAtACoarserFinestLevel)
{
  scene_.writeImages (folder_);
  expectRefusal (imageArguments() + " --finest-level 9 --output " + folder_ ("out"),
                 "--finest-level must be in [0, 4]");
  const ToolRun done =
      run (imageArguments() + " --finest-level 1 --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  checkFlow (io::readFlow (result ("flow_0_1.flo")));
}

} // namespace
