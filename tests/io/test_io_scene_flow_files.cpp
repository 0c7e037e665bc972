// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/result_files.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

const float kNan = std::numeric_limits<float>::quiet_NaN();
const cv::Size kSize (32, 24);

SceneFlow
someFlow ()
{
  SceneFlow flow;
  flow.camera = {40.0, 42.0, 15.0, 12.0};
  flow.points.create (kSize, CV_32FC3);
  flow.displacement = cv::Mat (kSize, CV_32FC3, cv::Scalar (0.05, 0, 0));
  flow.labels = cv::Mat (kSize, CV_32SC1, cv::Scalar (0));
  flow.labels.colRange (16, 32).setTo (1);
  flow.visibility =
      cv::Mat (kSize, CV_8UC1, cv::Scalar (pixelValue (Visibility::Visible)));
  for (int row = 0; row < kSize.height; ++row)
    for (int col = 0; col < kSize.width; ++col) {
      const Eigen::Vector3f p =
          flow.camera.backProject (col, row, 1.0 + 0.02 * row).cast<float>();
      flow.points.at<cv::Vec3f> (row, col) = {p.x(), p.y(), p.z()};
    }
  flow.points.at<cv::Vec3f> (0, 0) = cv::Vec3f::all (kNan);
  flow.labels.at<int> (0, 0) = -1;
  flow.visibility.at<unsigned char> (0, 0) = pixelValue (Visibility::NoDepth);
  flow.visibility.at<unsigned char> (1, 1) = pixelValue (Visibility::Occluded);
  flow.displacement.at<cv::Vec3f> (2, 2) = cv::Vec3f::all (kNan);
  return flow;
}

TEST (SceneFlowFiles, CloudComesBack)
{
  const TemporaryFolder folder;
  const SceneFlow flow = someFlow();
  cv::Mat color (kSize, CV_8UC3, cv::Scalar (10, 20, 30));
  color.at<cv::Vec3b> (5, 6) = {200, 100, 50};
  io::writeSceneFlowCloud (folder ("s.pcd"), flow, color);
  const io::StoredSceneFlow stored = io::readSceneFlowCloud (folder ("s.pcd"));
  const SceneFlow& read = stored.scene_flow;
  EXPECT_EQ (stored.color.at<cv::Vec3b> (5, 6), cv::Vec3b (200, 100, 50));
  io::writeSceneFlowCloud (folder ("colourless.pcd"), flow, cv::Mat());
  EXPECT_TRUE (io::readSceneFlowCloud (folder ("colourless.pcd")).color.empty());
  EXPECT_NEAR (read.camera.fx, 40.0, 1e-3);
  EXPECT_NEAR (read.camera.cy, 12.0, 1e-3);
  EXPECT_EQ (cv::countNonZero (read.labels != flow.labels), 0);
  EXPECT_EQ (read.points.at<cv::Vec3f> (7, 9), flow.points.at<cv::Vec3f> (7, 9));
  EXPECT_TRUE (std::isnan (read.points.at<cv::Vec3f> (0, 0)[2]));
  EXPECT_EQ (read.visibility.at<unsigned char> (0, 0), Visibility::NoDepth);
  EXPECT_EQ (read.visibility.at<unsigned char> (1, 1), Visibility::Unknown);
  EXPECT_EQ (read.visibility.at<unsigned char> (3, 3), Visibility::Visible);
  // 0.05 m at 1.1 m with f = 40 px
  EXPECT_NEAR (read.flow.at<cv::Vec2f> (5, 9)[0], 40 * 0.05 / 1.1, 1e-3);
  EXPECT_TRUE (std::isnan (read.flow.at<cv::Vec2f> (2, 2)[0]));
  ASSERT_EQ (read.segments.size(), 2U);
  EXPECT_EQ (read.segments[0].points, 16 * 24 - 1);
  EXPECT_EQ (read.segments[0].visible_points, 16 * 24 - 2);
}

TEST (SceneFlowFiles, DeviationsComeBackWhereTheFileHasThem)
{
  const TemporaryFolder folder;
  SceneFlow flow = someFlow();
  flow.flow_deviation = cv::Mat (kSize, CV_32FC1, cv::Scalar (0.25));
  flow.displacement_deviation = cv::Mat (kSize, CV_32FC1, cv::Scalar (0.001));
  flow.flow_deviation.at<float> (2, 2) = kNan;
  io::writeSceneFlowCloud (folder ("s.pcd"), flow, cv::Mat());
  const SceneFlow read = io::readSceneFlowCloud (folder ("s.pcd")).scene_flow;
  EXPECT_EQ (read.flow_deviation.at<float> (3, 3), 0.25F);
  EXPECT_TRUE (std::isnan (read.flow_deviation.at<float> (2, 2)));
  EXPECT_EQ (read.displacement_deviation.at<float> (3, 3), 0.001F);
}

TEST (SceneFlowFiles, TheViewpointStays)
{
  const TemporaryFolder folder;
  const io::Viewpoint viewpoint{{1.0F, 2.0F, 3.0F}, {0.0F, 1.0F, 0.0F, 0.0F}};
  io::writeSceneFlowCloud (folder ("s.pcd"), someFlow(), cv::Mat(), viewpoint);
  io::writeWarpedCloud (folder ("w.pcd"), someFlow(), cv::Mat(), viewpoint);
  for (const io::Viewpoint& read :
       {io::readSceneFlowCloud (folder ("s.pcd")).viewpoint,
        io::readCloudImages (folder ("w.pcd"), someFlow().camera).viewpoint}) {
    EXPECT_EQ (read.origin, viewpoint.origin);
    EXPECT_EQ (read.orientation, viewpoint.orientation);
  }
  io::writeWarpedCloud (folder ("none.pcd"), someFlow(), cv::Mat());
  EXPECT_NE (readFile (folder ("none.pcd")).find ("VIEWPOINT 0 0 0 1 0 0 0\n"),
             std::string::npos);
}

TEST (SceneFlowFiles, OtherCloudsAreRefused)
{
  const TemporaryFolder folder;
  io::writeWarpedCloud (folder ("w.pcd"), someFlow(), cv::Mat());
  expectIoError ([&] { io::readSceneFlowCloud (folder ("w.pcd")); }, "w.pcd", "dx");
  expectIoError ([&] { io::readSceneFlowCloud (folder ("none.pcd")); }, "none.pcd", "");
  SceneFlow flow = someFlow();
  flow.labels.at<int> (3, 3) = 1 << 28;
  io::writeSceneFlowCloud (folder ("l.pcd"), flow, cv::Mat());
  expectIoError ([&] { io::readSceneFlowCloud (folder ("l.pcd")); }, "l.pcd", "label");
  const std::string bytes = readFile (folder ("w.pcd"));
  writeFile (folder ("cut.pcd"), bytes.substr (0, bytes.size() / 2));
  expectIoError ([&] { io::readSceneFlowCloud (folder ("cut.pcd")); }, "cut.pcd", "");
}

TEST (SceneFlowFiles, MotionGroupsGoThroughAnImage)
{
  SceneFlow flow = someFlow();
  flow.segments.resize (2);
  for (int i = 0; i < 2; ++i) {
    flow.segments[i].status = MotionStatus::Determined;
    flow.segments[i].points = 100 * (i + 1);
    flow.segments[i].group = 1 - i;
  }
  flow.groups = 2;
  const cv::Mat groups = io::groupImage (flow);
  EXPECT_EQ (groups.at<int> (5, 5), 1);
  EXPECT_EQ (groups.at<int> (5, 20), 0);
  EXPECT_EQ (groups.at<int> (0, 0), -1);
  SceneFlow other = flow;
  for (SegmentMotion& segment : other.segments)
    segment.group = -1;
  io::setGroups (groups, other);
  EXPECT_EQ (other.segments[0].group, 1);
  EXPECT_EQ (other.segments[1].group, 0);
  EXPECT_EQ (other.groups, 2);
  EXPECT_EQ (other.dominant_group, 0) << "the group with most points";
  EXPECT_THROW (io::setGroups (cv::Mat (2, 2, CV_32SC1), other), InvalidInput);
  flow.segments[0].status = MotionStatus::Undetermined;
  EXPECT_EQ (io::groupImage (flow).at<int> (5, 5), -1);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
TEST (SceneFlowFiles, MotionGroupsKeepTheirFormerNames)
{
  SceneFlow flow = someFlow();
  flow.segments.resize (2);
  flow.bodies = 2;
  flow.dominant_body = 1;
  flow.segments[0].body = 1;
  EXPECT_EQ (flow.groups, 2);
  EXPECT_EQ (flow.dominant_group, 1);
  EXPECT_EQ (flow.segments[0].group, 1);
  io::setBodies (io::bodyImage (flow), flow);
  EXPECT_EQ (flow.segments[1].body, -1);
}
#pragma GCC diagnostic pop

} // namespace
