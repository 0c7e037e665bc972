// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgcodecs.hpp>

#include "expect_io_error.h"
#include "temporary_folder.h"
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace {

using namespace pcl_msf;
using pcl_msf::testing::expectIoError;
using pcl_msf::testing::readFile;
using pcl_msf::testing::TemporaryFolder;
using pcl_msf::testing::writeFile;

const float kNan = std::numeric_limits<float>::quiet_NaN();

TEST (Images, DepthUnitsBecomeMetres)
{
  const TemporaryFolder folder;
  const cv::Mat units = (cv::Mat_<std::uint16_t> (1, 3) << 0, 5000, 65535);
  cv::imwrite (folder ("d.png"), units);
  const cv::Mat depth = io::readDepth (folder ("d.png"), 5000.0);
  ASSERT_EQ (depth.type(), CV_32FC1);
  EXPECT_EQ (depth.at<float> (0, 0), 0.0F);
  EXPECT_FLOAT_EQ (depth.at<float> (0, 1), 1.0F);
  EXPECT_FLOAT_EQ (depth.at<float> (0, 2), 13.107F);
}

TEST (Images, FloatDepthIsMetresWhateverTheScale)
{
  const TemporaryFolder folder;
  const cv::Mat metres = (cv::Mat_<float> (2, 2) << 0.5F, 1.5F, 2.5F, 3.5F);
  cv::imwrite (folder ("d.tiff"), metres);
  io::writePfm (folder ("d.pfm"), metres);
  io::writeDpt (folder ("d.DPT"), metres);
  for (const char* name : {"d.tiff", "d.pfm", "d.DPT"})
    EXPECT_EQ (cv::norm (io::readDepth (folder (name), 1000.0), metres, cv::NORM_INF),
               0)
        << name;
}

TEST (Images, DepthRoundTripDropsWhatIsNoMeasurement)
{
  const TemporaryFolder folder;
  const cv::Mat depth = (cv::Mat_<float> (1, 4) << 1.234F, kNan, -1.0F, 1e6F);
  io::writeDepth (folder ("d.png"), depth, 1000.0);
  const cv::Mat back = io::readDepth (folder ("d.png"), 1000.0);
  EXPECT_FLOAT_EQ (back.at<float> (0, 0), 1.234F);
  for (int col = 1; col < 4; ++col)
    EXPECT_EQ (back.at<float> (0, col), 0.0F);
}

TEST (Images, RefusesWhatIsNoDepth)
{
  const TemporaryFolder folder;
  cv::imwrite (folder ("c.png"), cv::Mat (2, 2, CV_8UC3, cv::Scalar::all (9)));
  writeFile (folder ("junk.png"), std::string (100, 'x'));
  expectIoError ([&] { io::readDepth (folder ("c.png"), 1.0); }, "c.png", "depth");
  expectIoError (
      [&] { io::readDepth (folder ("junk.png"), 1.0); }, "junk.png", "depth");
  for (const double scale : {0.0, -1.0, double{kNan}})
    expectIoError (
        [&] { io::readDepth (folder ("c.png"), scale); }, "c.png", "depth scale");
}

TEST (Images, RefusesCutAndAbsurdPngs)
{
  const TemporaryFolder folder;
  cv::imwrite (folder ("c.png"), cv::Mat (32, 32, CV_8UC1, cv::Scalar::all (9)));
  const std::string bytes = readFile (folder ("c.png"));
  for (const std::size_t size : {std::size_t{0},
                                 std::size_t{9},
                                 std::size_t{30},
                                 bytes.size() - 12,
                                 bytes.size() - 13}) {
    writeFile (folder ("cut.png"), bytes.substr (0, size));
    expectIoError ([&] { io::readColor (folder ("cut.png")); }, "cut.png", "colour");
  }
  std::string huge = bytes;
  huge.replace (16, 8, std::string ("\x3B\x9A\xCA\0\x3B\x9A\xCA\0", 8));
  writeFile (folder ("huge.png"), huge);
  expectIoError ([&] { io::readColor (folder ("huge.png")); }, "huge.png", "width");
}

TEST (Images, ColourIsEightBitGreyOrBgr)
{
  const TemporaryFolder folder;
  cv::imwrite (folder ("gray.png"), cv::Mat (2, 3, CV_8UC1, cv::Scalar (7)));
  cv::imwrite (folder ("alpha.png"), cv::Mat (2, 3, CV_8UC4, cv::Scalar (1, 2, 3, 4)));
  cv::imwrite (folder ("deep.png"), cv::Mat (2, 3, CV_16UC1, cv::Scalar (512)));
  EXPECT_EQ (io::readColor (folder ("gray.png")).type(), CV_8UC1);
  EXPECT_EQ (io::readColor (folder ("deep.png")).at<unsigned char> (0, 0), 2);
  const cv::Mat bgr = io::readColor (folder ("alpha.png"));
  ASSERT_EQ (bgr.type(), CV_8UC3);
  EXPECT_EQ (bgr.at<cv::Vec3b> (0, 0), cv::Vec3b (1, 2, 3));
}

TEST (Images, LabelsRoundTripIn16Bits)
{
  const TemporaryFolder folder;
  const cv::Mat labels = (cv::Mat_<int> (1, 4) << -1, 0, 300, 65534);
  io::writeLabels (folder ("l.png"), labels);
  const cv::Mat raw = cv::imread (folder ("l.png"), cv::IMREAD_UNCHANGED);
  ASSERT_EQ (raw.type(), CV_16UC1);
  EXPECT_EQ (raw.at<std::uint16_t> (0, 0), 65535);
  EXPECT_EQ (raw.at<std::uint16_t> (0, 2), 300);
  EXPECT_EQ (cv::countNonZero (io::readLabels (folder ("l.png")) != labels), 0);
  const cv::Mat many (1, 1, CV_32SC1, cv::Scalar (65535));
  expectIoError ([&] { io::writeLabels (folder ("m.png"), many); }, "m.png", "labels");
}

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
  expectIoError (camera ("500 500 320 240 640 480 1 9"), "camera.txt", "end");
  writeFile (folder ("pose.txt"), "2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  expectIoError ([&] { io::readPose (folder ("pose.txt")); }, "pose.txt", "matrix");
}

TEST (TextFiles, PoseRoundTrips)
{
  const TemporaryFolder folder;
  const RigidPose pose{{0.1, -0.2, 0.3, 1.0, 2.0, -3.0}};
  io::writePose (folder ("pose.txt"), pose);
  const RigidPose back = io::readPose (folder ("pose.txt"));
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR (back.parameters[i], pose.parameters[i], 1e-12);
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
