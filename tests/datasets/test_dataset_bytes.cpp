// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "io/datasets/flying_things_files.h"
#include "io/datasets/kitti_files.h"
#include "io/datasets/virtual_kitti_files.h"
#include "support/literal_bytes.h"
#include "support/temporary_folder.h"

#include <cmath>

// Tiny files of the data sets, spelled byte by byte from their descriptions: a reader
// and the tests' writers that misread one in the same way fail here.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

/** A 16-bit PNG. \param head width, height, bits, colour type, three zeros, checksum
 * \param data of the stored block with lengths and checksums; samples are in network
 * order, each row begins with a zero */
std::string
png (const std::string& head, const std::string& data)
{
  return bytes ("\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR") + head + data +
         bytes ("\0\0\0\0IEND\xAE\x42\x60\x82");
}

const std::string kTwoColours = bytes ("\0\0\0\x02\0\0\0\x01\x10\x02\0\0\0"
                                       "\x2B\xD0\x34\x9E");

class DatasetBytes : public ::testing::Test {
protected:
  std::string
  made (const std::string& content) const
  {
    writeFile (folder_ ("file"), content);
    return folder_ ("file");
  }

  const TemporaryFolder folder_;
};

bool
isNone (const cv::Vec2f& v)
{
  return std::isnan (v[0]) && std::isnan (v[1]);
}

// The development kit's flow_read: u = (red - 2^15) / 64, v of green, blue = valid.
TEST_F (DatasetBytes, KittiFlow)
{
  const cv::Mat flow = io::readKittiFlow (
      made (png (kTwoColours,
                 bytes ("\0\0\0\x18IDAT\x78\x01\x01\x0D\0\xF2\xFF\0"
                        "\x80\x40"         // u = 64 / 64
                        "\x7F\x80"         // v = -128 / 64, upwards
                        "\0\x01"           // valid
                        "\x80\0\x80\0\0\0" // invalid
                        "\x17\x4A\x02\xC1\xDF\xF7\x2C\x4B")))); // checksums
  ASSERT_EQ (flow.size(), cv::Size (2, 1));
  EXPECT_EQ (flow.at<cv::Vec2f> (0, 0), cv::Vec2f (1.0F, -2.0F));
  EXPECT_TRUE (isNone (flow.at<cv::Vec2f> (0, 1)));
}

// The development kit's disp_read: value / 256, 0 = invalid.
TEST_F (DatasetBytes, KittiDisparity)
{
  const cv::Mat disparity = io::readKittiDisparity (
      made (png (bytes ("\0\0\0\x02\0\0\0\x01\x10\0\0\0\0\x81\xD9\xFC\x15"),
                 bytes ("\0\0\0\x10IDAT\x78\x01\x01\x05\0\xFA\xFF\0"
                        "\x01\x80" // 384 / 256
                        "\0\0"     // invalid
                        "\x01\x89\0\x82\x04\xE6\x28\x4F"))));
  ASSERT_EQ (disparity.size(), cv::Size (2, 1));
  EXPECT_EQ (disparity.at<float> (0, 0), 1.5F);
  EXPECT_FALSE (disparity.at<float> (0, 1) > 0.0F);
}

// calib_cam_to_cam of 2011_09_26, as it is published.
TEST_F (DatasetBytes, KittiCamera)
{
  const io::KittiCamera found = io::readKittiCamera (made (
      "P_rect_02: 7.215377e+02 0.000000e+00 6.095593e+02 4.485728e+01 0.000000e+00 "
      "7.215377e+02 1.728540e+02 2.163791e-01 0.000000e+00 0.000000e+00 1.000000e+00 "
      "2.745884e-03\n"
      "P_rect_03: 7.215377e+02 0.000000e+00 6.095593e+02 -3.395242e+02 0.000000e+00 "
      "7.215377e+02 1.728540e+02 2.199936e+00 0.000000e+00 0.000000e+00 1.000000e+00 "
      "2.729905e-03\n"));
  EXPECT_EQ (found.camera.fx, 721.5377);
  EXPECT_EQ (found.camera.fy, 721.5377);
  EXPECT_EQ (found.camera.cx, 609.5593);
  EXPECT_EQ (found.camera.cy, 172.854);
  EXPECT_NEAR (found.baseline, 0.5327, 1e-4) << "the two cameras are 0.53 m apart";
}

// "2 / (2^16 - 1) bgr[..., 2:0:-1] - 1, times w - 1 and h - 1; blue = valid".
TEST_F (DatasetBytes, VirtualKittiFlow)
{
  const cv::Mat flow = io::readVirtualKittiFlow (
      made (png (bytes ("\0\0\0\x03\0\0\0\x02\x10\x02\0\0\0\x42\x86\x2D\x0E"),
                 bytes ("\0\0\0\x31IDAT\x78\x01\x01\x26\0\xD9\xFF\0"
                        "\xFF\xFF\0\0\0\x01"       // u = 2, v = -1
                        "\x33\x33\x33\x33\0\x01"   // -0.6 of either
                        "\xFF\xFF\xFF\xFF\0\0\0"   // invalid; a new row
                        "\0\0\xFF\xFF\0\x01"       // u = -2, v = 1
                        "\0\0\0\0\0\0\0\0\0\0\0\0" // invalid
                        "\xDD\x29\x08\xC8\x17\xFC\xFB\xBC"))));
  ASSERT_EQ (flow.size(), cv::Size (3, 2));
  EXPECT_EQ (flow.at<cv::Vec2f> (0, 0), cv::Vec2f (2.0F, -1.0F));
  EXPECT_NEAR (flow.at<cv::Vec2f> (0, 1)[0], -1.2F, 1e-6F);
  EXPECT_NEAR (flow.at<cv::Vec2f> (0, 1)[1], -0.6F, 1e-6F);
  EXPECT_EQ (flow.at<cv::Vec2f> (1, 0), cv::Vec2f (-2.0F, 1.0F));
  for (const cv::Point& none : {cv::Point (2, 0), cv::Point (1, 1), cv::Point (2, 1)})
    EXPECT_TRUE (isNone (flow.at<cv::Vec2f> (none))) << none;
}

// Red, green, blue are x, y, z, [0, 65535] being [-10, 10] m.
TEST_F (DatasetBytes, VirtualKittiSceneFlow)
{
  const cv::Mat motion = io::readVirtualKittiSceneFlow (
      made (png (kTwoColours,
                 bytes ("\0\0\0\x18IDAT\x78\x01\x01\x0D\0\xF2\xFF\0"
                        "\x33\x33"             // x = -6
                        "\x66\x66"             // y = -2
                        "\x99\x99"             // z = 2
                        "\xFF\xFF\x80\0\x80\0" // x is cut off
                        "\x23\x20\x05\x63\x05\xEC\x78\xDA"))));
  ASSERT_EQ (motion.size(), cv::Size (2, 1));
  const cv::Vec3f found = motion.at<cv::Vec3f> (0, 0);
  EXPECT_LT (cv::norm (found - cv::Vec3f (-6.0F, -2.0F, 2.0F)), 1e-5);
  EXPECT_TRUE (std::isnan (motion.at<cv::Vec3f> (0, 1)[1]));
}

// "Frame N", L and R: world from camera by rows, x right, y up, z backwards.
TEST_F (DatasetBytes, FlyingThingsCameras)
{
  const auto left = io::readCameraData (made ("Frame 6\n"
                                              "L 1 0 0 1.5 0 1 0 2 0 0 1 3 0 0 0 1\n"
                                              "R 1 0 0 2.5 0 1 0 2 0 0 1 3 0 0 0 1\n"),
                                        'L');
  ASSERT_EQ (left.count (6), 1U);
  const Eigen::Vector3d p = left.at (6) * Eigen::Vector3d (0.0, 1.0, 10.0);
  EXPECT_LT ((p - Eigen::Vector3d (1.5, 1.0, -7.0)).norm(), 1e-9)
      << "ten metres ahead and one below";
}

// PF, three channels, negative scale: little-endian, the lowest row first.
TEST_F (DatasetBytes, FlyingThingsFlow)
{
  const cv::Mat flow = io::readFlyingThingsFlow (
      made (bytes ("PF\n1 2\n-1\n"
                   "\0\0\x80\x3F\0\0\0\xC0\0\0\0\0"     // below: 1, -2
                   "\0\0\x40\x40\0\0\0\x3F\0\0\0\0"))); // above: 3, 0.5
  ASSERT_EQ (flow.size(), cv::Size (1, 2));
  EXPECT_EQ (flow.at<cv::Vec2f> (0, 0), cv::Vec2f (3.0F, 0.5F));
  EXPECT_EQ (flow.at<cv::Vec2f> (1, 0), cv::Vec2f (1.0F, -2.0F));
}

} // namespace
