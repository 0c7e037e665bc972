// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_io.h>

#include "core/base/number_text.h"
#include "core/base/tuning/tuning.h"
#include "io/base/json.h"
#include "io/results/pcd_bytes.h"
#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/point_types.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

const float kNan = std::numeric_limits<float>::quiet_NaN();

/** Two by two points: known, no depth, undetermined, occluded. */
SceneFlow
smallResult ()
{
  SceneFlow flow;
  flow.labels = (cv::Mat_<int> (2, 2) << 0, -1, 1, 0);
  flow.points = cv::Mat (2, 2, CV_32FC3, cv::Scalar (1, 2, 3));
  flow.points.at<cv::Vec3f> (0, 1) = {kNan, kNan, kNan};
  flow.displacement = cv::Mat (2, 2, CV_32FC3, cv::Scalar (0.5, 0, -1));
  flow.displacement.at<cv::Vec3f> (0, 1) = {kNan, kNan, kNan};
  flow.displacement.at<cv::Vec3f> (1, 0) = {kNan, kNan, kNan};
  flow.flow = cv::Mat (2, 2, CV_32FC2, cv::Scalar (1, 1));
  flow.visibility = (cv::Mat_<unsigned char> (2, 2) << 255, 0, 255, 128);
  flow.flow_deviation = (cv::Mat_<float> (2, 2) << 0.5F, kNan, kNan, 2.0F);
  flow.displacement_deviation = 0.01 * flow.flow_deviation;
  flow.segments.resize (2);
  flow.segments[0].status = MotionStatus::Determined;
  return flow;
}

TEST (ResultFiles, SceneFlowCloudReadsBack)
{
  const TemporaryFolder folder;
  const cv::Mat color (2, 2, CV_8UC3, cv::Scalar (10, 20, 30));
  io::writeSceneFlowCloud (folder ("a.pcd"), smallResult(), color);
  EXPECT_EQ (pcl_msf::testing::filesIn (folder ("")), 1U);
  EXPECT_NE (readFile (folder ("a.pcd"))
                 .find ("FIELDS x y z rgb dx dy dz label visible "
                        "flow_deviation displacement_deviation\n"),
             std::string::npos);
  pcl::PointCloud<PointXYZRGBFlow> cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (folder ("a.pcd"), cloud), 0);
  ASSERT_EQ (cloud.width, 2U);
  ASSERT_EQ (cloud.height, 2U);
  EXPECT_EQ (cloud (0, 0).z, 3.0F);
  EXPECT_EQ (cloud (0, 0).r, 30);
  EXPECT_EQ (cloud (0, 0).dz, -1.0F);
  EXPECT_EQ (cloud (0, 0).visible, 255);
  EXPECT_TRUE (std::isnan (cloud (1, 0).x) && std::isnan (cloud (1, 0).dx));
  EXPECT_EQ (cloud (1, 0).label, PointXYZRGBFlow::kNoLabel);
  EXPECT_TRUE (std::isfinite (cloud (0, 1).x) && std::isnan (cloud (0, 1).dy));
  EXPECT_EQ (cloud (0, 1).label, 1U);
  EXPECT_EQ (cloud (1, 1).visible, 0) << "occluded";
  EXPECT_EQ (cloud (1, 1).flow_deviation, 2.0F);
  EXPECT_EQ (cloud (1, 1).displacement_deviation, 0.02F);
  EXPECT_TRUE (std::isnan (cloud (0, 1).flow_deviation));
}

TEST (ResultFiles, CloudsAreTheBytesThatPclWrites)
{
  const TemporaryFolder folder;
  io::writeSceneFlowCloud (
      folder ("a.pcd"), smallResult(), cv::Mat(), {{1, -2, 0.5F}, {0.6F, 0.8F, 0, 0}});
  pcl::PointCloud<PointXYZRGBFlow> cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (folder ("a.pcd"), cloud), 0);
  ASSERT_EQ (pcl::PCDWriter().writeBinary (folder ("pcl.pcd"), cloud), 0);
  EXPECT_EQ (readFile (folder ("a.pcd")), readFile (folder ("pcl.pcd")));
  EXPECT_EQ (io::pcdBytes (cloud), readFile (folder ("pcl.pcd")));
  pcl::PointCloud<pcl::PointNormal> padded (3, 1); // of x y z _ and n _ curvature _
  padded[1].normal_y = 7.0F;
  ASSERT_EQ (pcl::PCDWriter().writeBinary (folder ("pcl.pcd"), padded), 0);
  EXPECT_EQ (io::pcdBytes (padded), readFile (folder ("pcl.pcd")));
}

TEST (ResultFiles, WarpedCloudIsOrganizedAndKnowsWhatItDoesNot)
{
  const TemporaryFolder folder;
  io::writeWarpedCloud (folder ("w.pcd"), smallResult(), cv::Mat());
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (folder ("w.pcd"), cloud), 0);
  ASSERT_TRUE (cloud.isOrganized());
  EXPECT_EQ (cloud (0, 0).x, 1.5F);
  EXPECT_EQ (cloud (0, 0).g, 255);
  EXPECT_TRUE (std::isnan (cloud (1, 0).z) && std::isnan (cloud (0, 1).z));
}

TEST (ResultFiles, RefusesWhatDoesNotFit)
{
  const TemporaryFolder folder;
  const cv::Mat color (3, 2, CV_8UC3);
  expectIoError ([&] { io::writeSceneFlowCloud (folder ("a.pcd"), {}, cv::Mat()); },
                 "a.pcd",
                 "scene flow");
  expectIoError ([&] { io::writeWarpedCloud (folder ("a.pcd"), smallResult(), color); },
                 "a.pcd",
                 "2x2 points and a colour image of 2x3");
  expectIoError (
      [&] { io::writeWarpedCloud (folder ("no/a.pcd"), smallResult(), cv::Mat()); },
      "a.pcd",
      "cannot be written");
  EXPECT_EQ (pcl_msf::testing::filesIn (folder ("")), 0U);
}

TEST (ResultFiles, MaskIsWhiteOnlyWhereSeenInBoth)
{
  const cv::Mat mask = io::visibilityMask (smallResult().visibility);
  EXPECT_EQ (mask.at<unsigned char> (0, 0), 255);
  EXPECT_EQ (mask.at<unsigned char> (1, 1), 0);
  EXPECT_EQ (cv::countNonZero (mask), 2);
}

TEST (Report, HasItsKeysAndNullForNotFinite)
{
  SceneFlow flow = smallResult();
  flow.report.message = "a \"quoted\"\nline";
  flow.report.stop_reason = StopReason::IterationLimit;
  flow.report.initial_cost.icp = std::numeric_limits<double>::infinity();
  flow.report.final_cost.brightness = 0.25;
  flow.report.history.push_back ({2, 0.75, 0.5, {0.5, 0.25, 0.0, 0.0}, 3});
  const std::string json = io::reportJson (flow, {1.5, 0.25, 0, 0, 0});
  EXPECT_THAT (json, ::testing::HasSubstr ("\"level\": 2"));
  EXPECT_THAT (json, ::testing::HasSubstr ("\"energy\": 3"));
  EXPECT_THAT (json, ::testing::HasSubstr ("\"brightness\": 0.5"));
  for (const char* part : {"\"frames\": 2",
                           "\"width\": 2",
                           "\"segments\": 2",
                           "\"undetermined_segments\": 1",
                           "\"converged\": false",
                           "\"light_changed\": false",
                           "\"stop_reason\": \"iteration_limit\"",
                           "\"total\": 1.5",
                           "\"load\": 0.25",
                           "\"initial\": null",
                           "\"final\": 0.25",
                           "a \\\"quoted\\\"\\nline",
                           "\"dominant_motion\": ["})
    EXPECT_NE (json.find (part), std::string::npos) << part << "\n" << json;
}

TEST (Report, TellsTunedValuesThatAreNotTheDefaults)
{
  const SceneFlow flow = smallResult();
  const std::string before = generalText (currentTuning().start.lost, 17);
  const std::string plain = io::reportJson (flow, {});
  setTuning ("start.lost", "0.625");
  const std::string changed = io::reportJson (flow, {});
  setTuning ("start.lost", before);
  EXPECT_EQ (io::reportJson (flow, {}), plain);
  const auto hash = [] (const std::string& json) {
    return json.substr (json.find ("\"tuning_hash\""), 34);
  };
  EXPECT_EQ (hash (plain).size(), 34U);
  EXPECT_NE (hash (plain), hash (changed));
  EXPECT_EQ (plain.find ("\"tuning\""), std::string::npos);
  EXPECT_THAT (changed, ::testing::HasSubstr ("\"start.lost\": \"0.625\""));
}

TEST (Json, KeepsOrderDigitsAndNotEveryByte)
{
  const io::Json json{{"z", -1},
                      {"a", {0.1, std::nan ("")}},
                      {"c", io::Json::object()},
                      {"d", true},
                      {"bytes", "a\xff"}};
  EXPECT_EQ (io::jsonText (json),
             "{\n  \"z\": -1,\n  \"a\": [\n    0.1,\n    null\n  ],\n  \"c\": {},\n"
             "  \"d\": true,\n  \"bytes\": \"a\xef\xbf\xbd\"\n}\n");
}

} // namespace
