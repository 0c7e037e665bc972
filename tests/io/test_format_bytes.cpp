// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "io/datasets/timed_lists.h"
#include "support/literal_bytes.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/point_files.h>
#include <pcl_msf/io/pose_files.h>

#include <cmath>

// Tiny files of the published formats, spelled byte by byte from their specifications:
// a reader and a writer that misread one in the same way fail here.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

class FormatBytes : public ::testing::Test {
protected:
  /** A file of these bytes. */
  std::string
  made (const std::string& name, const std::string& content) const
  {
    writeFile (folder_ (name), content);
    return folder_ (name);
  }

  const TemporaryFolder folder_;
};

// Baker et al., "A Database and Evaluation Methodology for Optical Flow": flowIO.
const std::string kFlo = bytes ("PIEH"               // 202021.25, little-endian
                                "\x02\0\0\0"         // width 2
                                "\x01\0\0\0"         // height 1
                                "\0\0\xC0\x3F"       // u 1.5
                                "\0\0\0\xC0"         // v -2, downwards
                                "\xF9\x02\x15\x50"   // u 1e10: unknown
                                "\xF9\x02\x15\x50"); // v 1e10

TEST_F (FormatBytes, Flo)
{
  const cv::Mat flow = io::readFlow (made ("a.flo", kFlo));
  ASSERT_EQ (flow.size(), cv::Size (2, 1));
  EXPECT_EQ (flow.at<cv::Vec2f> (0, 0), cv::Vec2f (1.5F, -2.0F));
  EXPECT_TRUE (std::isnan (flow.at<cv::Vec2f> (0, 1)[0]));
  io::writeFlow (folder_ ("b.flo"), flow);
  EXPECT_EQ (readFile (folder_ ("b.flo")), kFlo);
}

// Debevec's portable float map: the bottom row first, a negative scale for
// little-endian.
const std::string kPfm = bytes ("Pf\n"
                                "1 2\n"
                                "-1\n"
                                "\0\0\x40\x40"   // 3, the lower pixel
                                "\0\0\x80\x3E"); // 0.25, the upper one

TEST_F (FormatBytes, Pfm)
{
  const cv::Mat image = io::readPfm (made ("a.pfm", kPfm));
  ASSERT_EQ (image.size(), cv::Size (1, 2));
  ASSERT_EQ (image.type(), CV_32FC1);
  EXPECT_EQ (image.at<float> (0, 0), 0.25F);
  EXPECT_EQ (image.at<float> (1, 0), 3.0F);
  io::writePfm (folder_ ("b.pfm"), image);
  EXPECT_EQ (readFile (folder_ ("b.pfm")), kPfm);
}

TEST_F (FormatBytes, PfmOfColourInNetworkOrder)
{
  const cv::Mat image = io::readPfm (made ("a.pfm",
                                           bytes ("PF\n"
                                                  "1 1\n"
                                                  "1.0\n"
                                                  "\x3F\x80\0\0"     // red 1
                                                  "\x40\0\0\0"       // green 2
                                                  "\x40\x40\0\0"))); // blue 3
  ASSERT_EQ (image.type(), CV_32FC3);
  EXPECT_EQ (image.at<cv::Vec3f> (0, 0), cv::Vec3f (1, 2, 3));
}

// Butler et al., "A naturalistic open source movie for optical flow evaluation": the
// SDK's cam_read, M 3x3 and N 3x4 with x = M N X.
TEST_F (FormatBytes, Cam)
{
  const std::string zero = bytes ("\0\0\0\0\0\0\0\0");
  const std::string one = bytes ("\0\0\0\0\0\0\xF0\x3F");
  const std::string minus_one = bytes ("\0\0\0\0\0\0\xF0\xBF");
  const std::string f = bytes ("\0\0\0\0\0\0\x84\x40");       // 640
  const std::string cx = bytes ("\0\0\0\0\0\0\x59\x40");      // 100
  const std::string cy = bytes ("\0\0\0\0\0\0\x08\x40");      // 3
  const std::string half = bytes ("\0\0\0\0\0\0\xE0\x3F");    // 0.5
  const std::string quarter = bytes ("\0\0\0\0\0\0\xD0\xBF"); // -0.25
  const std::string cam = "PIEH" +                            // 202021.25
                          f + zero + cx +                     // M by rows
                          zero + f + cy +                     //
                          zero + zero + one +                 //
                          zero + minus_one + zero + half +    // N by rows: camera x is
                          one + zero + zero + quarter +       // world -y, camera y
                          zero + zero + one + one;            // world x, z stays
  RigidPose camera_from_world;
  const PinholeCamera camera = io::readCam (made ("a.cam", cam), camera_from_world);
  EXPECT_EQ (camera.fx, 640.0);
  EXPECT_EQ (camera.fy, 640.0);
  EXPECT_EQ (camera.cx, 100.0);
  EXPECT_EQ (camera.cy, 3.0);
  const Eigen::Vector3d moved = camera_from_world * Eigen::Vector3d (2, 3, 4);
  EXPECT_LT ((moved - Eigen::Vector3d (-2.5, 1.75, 5)).norm(), 1e-12);
  // Of a rotation only its vector is kept: what is written is read back by value.
  io::writeCam (folder_ ("b.cam"), camera, RigidPose());
  EXPECT_EQ (readFile (folder_ ("b.cam")),
             "PIEH" + f + zero + cx + zero + f + cy + zero + zero + one + //
                 one + zero + zero + zero +                               //
                 zero + one + zero + zero +                               //
                 zero + zero + one + zero);
}

// The TUM RGB-D benchmark's file formats; the pose is the first line of fr1/xyz that
// its page on file formats shows.
TEST_F (FormatBytes, TumTrajectory)
{
  const auto poses = io::readTrajectory (
      made ("a.txt",
            "# ground truth trajectory\n"
            "# timestamp tx ty tz qx qy qz qw\n"
            "1305031098.6659 1.3563 0.6305 1.6380 0.6132 0.5962 -0.3311 -0.3986\n"));
  ASSERT_EQ (poses.size(), 1U);
  EXPECT_DOUBLE_EQ (poses[0].seconds, 1305031098.6659);
  const RigidPose& pose = poses[0].world_from_camera;
  EXPECT_LT ((pose.translation() - Eigen::Vector3d (1.3563, 0.6305, 1.6380)).norm(),
             1e-12);
  // Of q = (x, y, z, w) the optical axis is (2 (xz + yw), 2 (yz - xw), 1 - 2 (xx +
  // yy)).
  const Eigen::Vector3d axis = pose.rotation() * Eigen::Vector3d::UnitZ();
  EXPECT_LT ((axis - Eigen::Vector3d (-0.8814, 0.0940, -0.4629)).norm(), 2e-4);
}

TEST_F (FormatBytes, TumTrajectoryAsWritten)
{
  io::TimedPose quarter; // a quarter turn about z: (0, 0, sin 45, cos 45)
  quarter.seconds = 12.25;
  quarter.world_from_camera.parameters = {0, 0, M_PI / 2, 1, -2, 3};
  io::writeTrajectory (folder_ ("b.txt"), {io::TimedPose(), quarter});
  EXPECT_EQ (readFile (folder_ ("b.txt")),
             "# timestamp tx ty tz qx qy qz qw\n"
             "0.000000 0 0 0 0 0 0 1\n"
             "12.250000 1 -2 3 0 0 0.707106781 0.707106781\n");
}

TEST_F (FormatBytes, TumList)
{
  const auto files =
      io::readTimedFiles (made ("rgb.txt",
                                "# color images\n"
                                "# file: 'rgbd_dataset_freiburg1_xyz.bag'\n"
                                "# timestamp filename\n"
                                "1305031102.175304 rgb/1305031102.175304.png\n"
                                "1305031102.211214 rgb/1305031102.211214.png\n"));
  ASSERT_EQ (files.size(), 2U);
  EXPECT_DOUBLE_EQ (files[1].time, 1305031102.211214);
  EXPECT_EQ (files[1].file, "rgb/1305031102.211214.png");
}

/** PCL's documentation of the PCD format, version 0.7; two points, the second none. */
std::string
pcdHeader (const std::string& width_and_height, const std::string& data)
{
  return "# .PCD v0.7 - Point Cloud Data file format\n"
         "VERSION 0.7\n"
         "FIELDS x y z rgb\n"
         "SIZE 4 4 4 4\n"
         "TYPE F F F U\n"
         "COUNT 1 1 1 1\n" +
         width_and_height +
         "VIEWPOINT 0 0 0 1 0 0 0\n"
         "POINTS 2\n"
         "DATA " +
         data + "\n";
}

const std::string kPcdPoints = bytes ("\0\0\xC0\x3F"     // x 1.5
                                      "\0\0\0\xC0"       // y -2
                                      "\0\0\x40\x40"     // z 3
                                      "\x0A\x14\xC8\0"   // blue 10, green 20, red 200
                                      "\0\0\xC0\x7F"     // NaN
                                      "\0\0\xC0\x7F"     // NaN
                                      "\0\0\xC0\x7F"     // NaN
                                      "\xFF\xFF\xFF\0"); // white

TEST_F (FormatBytes, PcdInTextAndBinary)
{
  // 0x00C8140A = 13112330, red above green above blue; 0x00FFFFFF = 16777215
  const std::string text = "1.5 -2 3 13112330\nnan nan nan 16777215\n";
  for (const std::string& path :
       {made ("text.pcd", pcdHeader ("WIDTH 2\nHEIGHT 1\n", "ascii") + text),
        made ("binary.pcd",
              pcdHeader ("WIDTH 2\nHEIGHT 1\n", "binary") + kPcdPoints)}) {
    const io::PointFile file = io::readPoints (path);
    ASSERT_EQ (file.points.size(), 2U) << path;
    EXPECT_EQ (file.points[0], Eigen::Vector3f (1.5F, -2.0F, 3.0F)) << path;
    EXPECT_TRUE (std::isnan (file.points[1].x())) << path;
    EXPECT_EQ (file.colors, (std::vector<std::uint32_t>{0xC8140AU, 0xFFFFFFU})) << path;
  }
}

TEST_F (FormatBytes, OrganizedPcd)
{
  const auto cloud = io::readOrganizedCloud (
      made ("a.pcd", pcdHeader ("WIDTH 1\nHEIGHT 2\n", "binary") + kPcdPoints));
  ASSERT_EQ (cloud->height, 2U);
  const auto& point = (*cloud) (0, 0);
  EXPECT_EQ (point.getVector3fMap(), Eigen::Vector3f (1.5F, -2.0F, 3.0F));
  EXPECT_EQ (cv::Vec3b (point.b, point.g, point.r), cv::Vec3b (10, 20, 200));
  EXPECT_TRUE (std::isnan ((*cloud) (0, 1).z));
}

TEST_F (FormatBytes, PcdAsWritten)
{
  CloudFlow flow;
  flow.warped = {{1.5F, -2.0F, 3.0F}};
  flow.part = {-1};
  flow.confidence = {0.25F};
  io::PointFile source;
  source.points = {{1.5F, 0.0F, 1.5F}};
  source.colors = {0xC8140AU};
  io::writeRegisteredCloud (folder_ ("b.pcd"), flow, source);
  const std::string written = readFile (folder_ ("b.pcd"));
  const std::string head = "FIELDS x y z rgb dx dy dz part confidence\n"
                           "SIZE 4 4 4 4 4 4 4 4 4\n"
                           "TYPE F F F U F F F I F\n";
  EXPECT_NE (written.find (head), std::string::npos);
  const std::string data = "DATA binary\n";
  EXPECT_EQ (written.substr (written.find (data) + data.size()),
             bytes ("\0\0\xC0\x3F"     // x 1.5
                    "\0\0\0\xC0"       // y -2
                    "\0\0\x40\x40"     // z 3
                    "\x0A\x14\xC8\0"   // blue, green, red
                    "\0\0\0\0"         // dx 0
                    "\0\0\0\xC0"       // dy -2
                    "\0\0\xC0\x3F"     // dz 1.5
                    "\xFF\xFF\xFF\xFF" // part -1
                    "\0\0\x80\x3E"));  // confidence 0.25
}

// Turk's "The PLY Polygon File Format".
TEST_F (FormatBytes, PlyInTextAndBothByteOrders)
{
  const std::string vertex = "element vertex 1\n"
                             "property float x\n"
                             "property float y\n"
                             "property float z\n";
  const std::string color = "property uchar red\n"
                            "property uchar green\n"
                            "property uchar blue\n";
  const auto ply = [&] (const std::string& format, const std::string& data) {
    return "ply\nformat " + format + " 1.0\ncomment made by hand\n" + vertex + color +
           "end_header\n" + data;
  };
  const std::string rgb = "\xC8\x14\x0A"; // 200 20 10
  for (const std::string& path :
       {made ("text.ply", ply ("ascii", "1.5 -2 3 200 20 10\n")),
        made ("little.ply",
              ply ("binary_little_endian",
                   bytes ("\0\0\xC0\x3F\0\0\0\xC0\0\0\x40\x40") + rgb)),
        made ("big.ply",
              ply ("binary_big_endian",
                   bytes ("\x3F\xC0\0\0\xC0\0\0\0\x40\x40\0\0") + rgb))}) {
    const io::PointFile file = io::readPoints (path);
    ASSERT_EQ (file.points.size(), 1U) << path;
    EXPECT_EQ (file.points[0], Eigen::Vector3f (1.5F, -2.0F, 3.0F)) << path;
    EXPECT_EQ (file.colors, std::vector<std::uint32_t>{0xC8140AU}) << path;
  }
  io::writePointsPly (folder_ ("b.ply"), {{1.5F, -2.0F, 3.0F}});
  EXPECT_EQ (readFile (folder_ ("b.ply")),
             "ply\nformat binary_little_endian 1.0\n" + vertex + "end_header\n" +
                 bytes ("\0\0\xC0\x3F\0\0\0\xC0\0\0\x40\x40"));
}

// ISO/IEC 15948: network byte order; three grey pixels of 16 bits in a stored block.
const std::string kPngHead = bytes ("\x89PNG\r\n\x1A\n"
                                    "\0\0\0\x0D"         // 13 bytes of
                                    "IHDR"               //
                                    "\0\0\0\x03"         // width 3
                                    "\0\0\0\x01"         // height 1
                                    "\x10"               // 16 bits a sample
                                    "\0"                 // of grey
                                    "\0\0\0"             // as usual, not interlaced
                                    "\x6E\x1B\x97\x2B"); // checksum
const std::string kPngData = bytes ("\0\0\0\x12"         // 18 bytes of
                                    "IDAT"               //
                                    "\x78\x01"           // zlib
                                    "\x01"               // the last block, stored:
                                    "\x07\0\xF8\xFF"     // 7 bytes and their complement
                                    "\0"                 // no filter
                                    "\0\x01"             // 1
                                    "\x03\xE8"           // 1000
                                    "\xFF\xFF"           // 65535, saturated
                                    "\x05\xCD\x02\xEB"   // Adler-32
                                    "\xFB\x87\x77\xE9"   // checksum
                                    "\0\0\0\0"           // nothing in
                                    "IEND"               //
                                    "\xAE\x42\x60\x82"); // checksum

TEST_F (FormatBytes, DepthPng)
{
  const cv::Mat depth = io::readDepth (made ("a.png", kPngHead + kPngData), 1000.0);
  ASSERT_EQ (depth.size(), cv::Size (3, 1));
  EXPECT_FLOAT_EQ (depth.at<float> (0, 0), 0.001F);
  EXPECT_FLOAT_EQ (depth.at<float> (0, 1), 1.0F);
  EXPECT_EQ (depth.at<float> (0, 2), 0.0F) << "no measurement";
  io::writeDepth (folder_ ("b.png"), depth, 1000.0);
  EXPECT_EQ (readFile (folder_ ("b.png")).substr (0, kPngHead.size()), kPngHead);
  EXPECT_EQ (cv::norm (io::readDepth (folder_ ("b.png"), 1000.0), depth, cv::NORM_INF),
             0.0);
}

} // namespace
