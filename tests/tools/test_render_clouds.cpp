// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// From clouds without a grid to pictures and the page.
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/box_chain.h"
#include "support/expect_refusal.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/point_files.h>

#include <filesystem>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;
using ::testing::Not;

class RenderClouds : public ::testing::Test {
protected:
  RenderClouds()
  {
    BoxChain chain;
    chain.boxes = 2;
    source_ = drawChain (chain, 3000, false, 1);
    io::writePointsPly (folder_ ("source.ply"), source_.points);
    io::writePointsPly (folder_ ("target.ply"),
                        drawChain (chain, 3000, true, 2).points);
    EXPECT_EQ (run ("register",
                    folder_ ("source.ply") + " " + folder_ ("target.ply") +
                        " --threads 1 --quiet --output " + folder_ ("result"))
                   .status,
               0);
  }
  ToolRun
  run (const std::string& tool, const std::string& arguments) const
  {
    return runTool (
        folder_, "env -u DISPLAY " PCL_MSF_TOOLS "/pcl_msf_" + tool + " " + arguments);
  }
  void
  expectRefusal (const std::string& arguments, const std::string& words) const
  {
    pcl_msf::testing::expectRefusal (
        run ("render", folder_ ("result ") + arguments), arguments, {words});
  }

  TemporaryFolder folder_;
  ChainCloud source_;
};

TEST_F (RenderClouds, FilesAreReadAgain)
{
  const io::RegisteredCloud cloud =
      io::readRegisteredCloud (folder_ ("result/registered.pcd"));
  ASSERT_EQ (cloud.source.size(), source_.points.size());
  for (std::size_t i = 0; i < source_.points.size(); ++i)
    ASSERT_LT ((cloud.source[i] - source_.points[i]).norm(), 1e-6F);
  EXPECT_EQ (io::readPoints (folder_ ("result/warped.ply")).points, cloud.warped);
  const auto joints = io::readJoints (folder_ ("result/joints.json"));
  ASSERT_EQ (joints.size(), 1u);
  EXPECT_NEAR (joints[0].angle, BoxChain().angle, 0.02);
  EXPECT_NEAR (joints[0].axis.norm(), 1.0, 1e-9);
}

TEST_F (RenderClouds, BothCloudsPartsAndThePage)
{
  const ToolRun drawn =
      run ("render",
           folder_ ("result") + " --sequence " + folder_ ("target.ply") +
               " --kind all --size 320x240 --output " + folder_ ("result"));
  ASSERT_EQ (drawn.status, 0) << drawn.err;
  for (const char* name : {"before_tints", "after_tints", "warped", "motions"}) {
    const cv::Mat image = cv::imread (folder_ ("result/") + name + ".png");
    ASSERT_EQ (image.size(), cv::Size (320, 240)) << name;
    cv::Mat shown;
    cv::inRange (image, cv::Scalar::all (255), cv::Scalar::all (255), shown);
    EXPECT_GT (cv::countNonZero (255 - shown), 2000) << name;
    // The body is whole: it does not reach the picture's border but for the words.
    EXPECT_EQ (cv::countNonZero (255 - shown.col (319)), 0) << name;
    EXPECT_EQ (cv::countNonZero (255 - shown.row (239)), 0) << name;
  }
  EXPECT_THAT (drawn.out, HasSubstr ("sheet.png"));
  ASSERT_EQ (
      run ("report", folder_ ("result") + " --output " + folder_ ("page.html")).status,
      0);
  const std::string page = readFile (folder_ ("page.html"));
  EXPECT_THAT (page, HasSubstr ("before_tints.png"));
  EXPECT_THAT (page, HasSubstr ("motions.png"));
  EXPECT_THAT (page, HasSubstr ("joints"));
}

TEST_F (RenderClouds, OneOfSeveralTargets)
{
  const std::string target = " " + folder_ ("target.ply");
  ASSERT_EQ (run ("register",
                  folder_ ("source.ply") + target + target + " --quiet --output " +
                      folder_ ("several"))
                 .status,
             0);
  const ToolRun drawn =
      run ("render",
           folder_ ("several") + " --frame 2 --sequence" + target +
               " --kind after_tints --size 160x120 --output " + folder_ ("drawn"));
  EXPECT_EQ (drawn.status, 0) << drawn.err;
  EXPECT_TRUE (std::filesystem::exists (folder_ ("drawn/after_tints.png")));
}

TEST_F (RenderClouds, SaysWhatItLacks)
{
  const std::string out = " --output " + folder_ ("out");
  expectRefusal ("--kind after_tints" + out, "the target has no points");
  expectRefusal ("--kind occlusion" + out, "clouds without a grid");
  expectRefusal ("--animation orbit" + out, "--animation");
  expectRefusal ("--sequence " + folder_ (".") + out, "is a folder");
  const ToolRun some =
      run ("render", folder_ ("result") + " --size 160x120 --kind all" + out);
  EXPECT_EQ (some.status, 0) << "without the target what can be drawn";
  EXPECT_THAT (some.out, Not (HasSubstr ("before_tints")));
  std::filesystem::remove (folder_ ("result/joints.json"));
  EXPECT_EQ (run ("render", folder_ ("result") + " --size 160x120 --kind motions" + out)
                 .status,
             0);
}

} // namespace
