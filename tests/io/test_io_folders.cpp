// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/expect_io_error.h"
#include "support/pose_matcher.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

TEST (TextFiles, CameraRoundTripsExactly)
{
  const TemporaryFolder folder;
  const io::CameraFile file{{525.1, 524.9, 319.5, 239.5}, 640, 480, 5000.0};
  io::writeCamera (folder ("camera.txt"), file);
  const io::CameraFile back = io::readCamera (folder ("camera.txt"));
  EXPECT_EQ (back.camera.fx, 525.1);
  EXPECT_EQ (back.camera.cy, 239.5);
  EXPECT_EQ (back.height, 480);
  EXPECT_EQ (back.depth_scale, 5000.0);
}

TEST (TextFiles, RefusesMalformedCamerasAndPoses)
{
  const TemporaryFolder folder;
  const auto camera = [&] (const std::string& text) {
    return [&folder, text] {
      writeFile (folder ("camera.txt"), text);
      io::readCamera (folder ("camera.txt"));
    };
  };
  expectIoError (camera (""), "camera.txt", "fx");
  expectIoError (camera ("500 500 320 240 640 480"), "camera.txt", "depth_scale");
  expectIoError (camera ("500 x 320 240 640 480 1"), "camera.txt", "fy");
  expectIoError (camera ("500 nan 320 240 640 480 1"), "camera.txt", "fy");
  expectIoError (camera ("500 500 320 240 6e40 480 1"), "camera.txt", "width");
  expectIoError (camera ("0 500 320 240 640 480 1"), "camera.txt", "fx");
  expectIoError (camera ("500 500 320 240 640 480 0"), "camera.txt", "depth_scale");
  expectIoError (camera ("500 500 320 240 640 480 1 9"), "camera.txt", "distortion");
  writeFile (folder ("pose.txt"), "2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  expectIoError ([&] { io::readPose (folder ("pose.txt")); }, "pose.txt", "matrix");
}

TEST (TextFiles, PoseRoundTrips)
{
  const TemporaryFolder folder;
  const RigidPose pose{{0.1, -0.2, 0.3, 1.0, 2.0, -3.0}};
  io::writePose (folder ("pose.txt"), pose);
  const RigidPose back = io::readPose (folder ("pose.txt"));
  EXPECT_THAT (back, test::isNear (pose, 1e-12, 1e-12));
}

/** A two-frame folder with all the ground truth there is. */
void
makeFolder (const TemporaryFolder& folder)
{
  std::filesystem::create_directory (folder ("gt"));
  io::writeCamera (folder ("camera.txt"), {{30, 30, 15.5, 11.5}, 32, 24, 1000});
  for (const char* k : {"0", "1"}) {
    const std::string name = k;
    io::writeImage (folder ("color_" + name + ".png"), cv::Mat (24, 32, CV_8UC3));
    io::writeDepth (
        folder ("depth_" + name + ".png"), cv::Mat (24, 32, CV_32F, 2.0), 1000);
  }
  io::writeFlow (folder ("gt/flow_0_1.flo"),
                 cv::Mat (24, 32, CV_32FC2, cv::Scalar (3, -1)));
  cv::Mat truth (24, 32, CV_32FC3, cv::Scalar (0.1, 0.2, 0.3));
  truth.at<cv::Vec3f> (0, 0)[1] = std::numeric_limits<float>::infinity();
  io::writePfm (folder ("gt/scene_flow_0_1.pfm"), truth);
  io::writeImage (folder ("gt/visible_0_1.png"), cv::Mat (24, 32, CV_8UC1, 255.0));
  io::writeLabels (folder ("gt/labels_0.png"), cv::Mat (24, 32, CV_32SC1, 4.0));
  io::writePose (folder ("gt/pose_1.txt"), {{0, 0, 0, 1, 2, 3}});
}

TEST (DataFolder, ReadsFramesAndTruth)
{
  const TemporaryFolder folder;
  makeFolder (folder);
  const io::DataFolder data (folder (""));
  ASSERT_EQ (data.frames(), 2);
  const io::RgbdImages images = data.frame (1);
  EXPECT_EQ (images.color.type(), CV_8UC3);
  EXPECT_FLOAT_EQ (images.depth.at<float> (3, 4), 2.0F);
  EXPECT_EQ (images.camera.cx, 15.5);
  EXPECT_EQ (data.flow (1).at<cv::Vec2f> (0, 0), cv::Vec2f (3.0F, -1.0F));
  const cv::Mat truth = data.sceneFlow (1);
  EXPECT_EQ (truth.at<cv::Vec3f> (5, 5), cv::Vec3f (0.1F, 0.2F, 0.3F));
  EXPECT_TRUE (std::isnan (truth.at<cv::Vec3f> (0, 0)[0]));
  EXPECT_EQ (cv::countNonZero (data.visible (1)), 24 * 32);
  EXPECT_EQ (data.labels().at<int> (9, 9), 4);
  ASSERT_TRUE (data.pose (1));
  EXPECT_EQ (data.pose (1)->translation().z(), 3.0);
  EXPECT_TRUE (data.flow (2).empty());
  EXPECT_FALSE (data.pose (0));
}

TEST (DataFolder, RefusesWhatIsNoFolderOfData)
{
  const TemporaryFolder folder;
  expectIoError ([&] { io::DataFolder (folder ("none")); }, "none", "no such folder");
  expectIoError ([&] { io::DataFolder (folder ("")); }, folder (""), "frame 0");
  io::writeDepth (folder ("depth_0.png"), cv::Mat (24, 32, CV_32F, 2.0), 1000);
  expectIoError ([&] { io::DataFolder (folder ("")); }, "camera.txt", "no such file");
  io::writeCamera (folder ("camera.txt"), {{30, 30, 15.5, 11.5}, 32, 23, 1000});
  const io::DataFolder data (folder (""));
  expectIoError ([&] { data.frame (0); }, "depth_0.png", "height");
}

TEST (DataFolder, ReadsRecordingsWhenThereAreAny)
{
  const char* path = std::getenv ("PCL_MSF_TEST_DATA");
  if (!path || !std::filesystem::is_directory (path))
    GTEST_SKIP() << "PCL_MSF_TEST_DATA names no folder of recordings";
  for (const auto& entry : std::filesystem::directory_iterator (path)) {
    if (!entry.is_directory())
      continue;
    const io::DataFolder data (entry.path().string());
    const io::RgbdImages images = data.frame (0);
    EXPECT_GT (cv::countNonZero (images.depth > 0), 1000) << entry.path();
    EXPECT_TRUE (images.camera.isValid (images.depth.cols, images.depth.rows));
  }
}

} // namespace
