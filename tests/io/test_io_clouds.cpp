// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_io.h>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include "support/wall_cloud.h"
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/data_folder.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

TEST (Clouds, EveryEncodingGivesTheImages)
{
  const TemporaryFolder folder;
  auto cloud = wall<pcl::PointXYZRGBA>();
  for (auto& point : cloud) {
    point.r = 200;
    point.b = 10;
  }
  pcl::PCDWriter writer;
  writer.writeASCII (folder ("ascii.pcd"), cloud);
  writer.writeBinary (folder ("binary.pcd"), cloud);
  writer.writeBinaryCompressed (folder ("packed.pcd"), cloud);
  for (const char* name : {"ascii.pcd", "binary.pcd", "packed.pcd"}) {
    const io::RgbdImages images = io::readCloudImages (folder (name), kCamera);
    ASSERT_EQ (images.depth.size(), cv::Size (40, 30)) << name;
    EXPECT_NEAR (images.depth.at<float> (7, 7), 2.0F, 1e-5) << name;
    EXPECT_TRUE (std::isnan (images.depth.at<float> (4, 3))) << name;
    EXPECT_EQ (images.color.at<cv::Vec3b> (7, 7), cv::Vec3b (10, 0, 200)) << name;
  }
}

TEST (Clouds, ColourComesFromIntensityOrNotAtAll)
{
  const TemporaryFolder folder;
  auto gray = wall<pcl::PointXYZI>();
  for (auto& point : gray)
    point.intensity = 0.4F;
  pcl::io::savePCDFileBinary (folder ("gray.pcd"), gray);
  pcl::io::savePCDFileBinary (folder ("plain.pcd"), wall<pcl::PointXYZ>());
  const io::RgbdImages images = io::readCloudImages (folder ("gray.pcd"), kCamera);
  EXPECT_EQ (images.color.at<cv::Vec3b> (7, 7), cv::Vec3b (102, 102, 102));
  EXPECT_TRUE (io::readCloudImages (folder ("plain.pcd")).color.empty());
}

TEST (Clouds, CameraIsFittedToAFlatWall)
{
  const TemporaryFolder folder;
  pcl::io::savePCDFileBinary (folder ("wall.pcd"), wall<pcl::PointXYZ>());
  const PinholeCamera camera = io::readCloudImages (folder ("wall.pcd")).camera;
  EXPECT_NEAR (camera.fx, kCamera.fx, 1e-3);
  EXPECT_NEAR (camera.fy, kCamera.fy, 1e-3);
  EXPECT_NEAR (camera.cx, kCamera.cx, 1e-3);
  EXPECT_NEAR (camera.cy, kCamera.cy, 1e-3);
}

TEST (Clouds, ACloudOfAnotherFrameGivesNoCamera)
{
  const TemporaryFolder folder;
  auto cloud = wall<pcl::PointXYZ>();
  for (auto& point : cloud)
    std::swap (point.x, point.y);
  pcl::io::savePCDFileBinary (folder ("turned.pcd"), cloud);
  expectIoError (
      [&] { io::readCloudImages (folder ("turned.pcd")); }, "turned.pcd", "camera");
  const pcl::PointCloud<pcl::PointXYZ> zeros (40, 30);
  pcl::io::savePCDFileBinary (folder ("zeros.pcd"), zeros);
  expectIoError (
      [&] { io::readCloudImages (folder ("zeros.pcd")); }, "zeros.pcd", "camera");
}

TEST (Clouds, ACloudThatIsNotTheGivenCamerasIsRefused)
{
  const TemporaryFolder folder;
  auto cloud = wall<pcl::PointXYZ>();
  for (auto& point : cloud)
    point.x = -point.x;
  pcl::io::savePCDFileBinary (folder ("mirror.pcd"), cloud);
  expectIoError ([&] { io::readCloudImages (folder ("mirror.pcd"), kCamera); },
                 "mirror.pcd",
                 "x is mirrored");
}

TEST (Clouds, RefusesMalformedFiles)
{
  const TemporaryFolder folder;
  const auto read = [&] (const std::string& bytes) {
    return [&folder, bytes] {
      writeFile (folder ("bad.pcd"), bytes);
      io::readOrganizedCloud (folder ("bad.pcd"));
    };
  };
  const auto header = [] (const std::string& size) {
    return "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n" + size +
           "VIEWPOINT 0 0 0 1 0 0 0\n";
  };
  expectIoError (read (""), "bad.pcd", "header");
  expectIoError (read (std::string (100000, 'x')), "bad.pcd", "header");
  expectIoError (read (header ("WIDTH 9\nHEIGHT 1\n") + "POINTS 9\nDATA ascii\n"),
                 "bad.pcd",
                 "not organized");
  expectIoError (read (header ("WIDTH x\nHEIGHT 2\n") + "POINTS 4\nDATA ascii\n"),
                 "bad.pcd",
                 "WIDTH");
  // PCL's reader crashes on these.
  expectIoError (
      read (header ("WIDTH 2\nHEIGHT 2\n") + "DATA ascii\n"), "bad.pcd", "POINTS");
  expectIoError (read ("FVERSION .7\n"), "bad.pcd", "'FVERSION' is no keyword");
  expectIoError (read (header ("WIDTH 2\nHEIGHT 2\nSIZE 4\n") + "DATA ascii\n"),
                 "bad.pcd",
                 "SIZE");
  expectIoError (read (header ("WIDTH 1000000000\nHEIGHT 1000000000\n") +
                       "POINTS 1000000000000000000\nDATA binary\n"),
                 "bad.pcd",
                 "POINTS");
  expectIoError (read (header ("WIDTH 100000\nHEIGHT 100000\n") +
                       "POINTS 10000000000\nDATA binary\n"),
                 "bad.pcd",
                 "width");
  expectIoError (
      read (header ("WIDTH 8000\nHEIGHT 8000\n") + "POINTS 64000000\nDATA binary\nxyz"),
      "bad.pcd",
      "points");
  expectIoError (read (header ("WIDTH 2\nHEIGHT 2\n") + "POINTS 3\nDATA ascii\n"),
                 "bad.pcd",
                 "POINTS");
  std::string turned = header ("WIDTH 2\nHEIGHT 2\n") + "POINTS 4\nDATA ascii\n";
  turned.replace (turned.find ("0 0 0 1"), 7, "0 0 0 w");
  expectIoError (read (turned + "1 2 3\n1 2 3\n1 2 3\n1 2 3\n"), "bad.pcd", "'w'");
  std::string nothing = header ("WIDTH 2\nHEIGHT 2\n");
  nothing.replace (nothing.find ("x y z"), 5, "a b c");
  expectIoError (read (nothing + "POINTS 4\nDATA binary\n" + std::string (48, '\0')),
                 "bad.pcd",
                 "field x");
}

TEST (Clouds, RefusesAColourThatIsNotFourBytes)
{
  const TemporaryFolder folder;
  writeFile (folder ("bad.pcd"),
             "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 1\nTYPE F F F U\n"
             "WIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA binary\n" +
                 std::string (52, '\1'));
  expectIoError (
      [&] { io::readOrganizedCloud (folder ("bad.pcd")); }, "bad.pcd", "field rgb");
}

TEST (Clouds, RefusesAPackedCloudThatIsCut)
{
  const TemporaryFolder folder;
  pcl::PCDWriter().writeBinaryCompressed (folder ("a.pcd"), wall<pcl::PointXYZ>());
  const std::string bytes = readFile (folder ("a.pcd"));
  const std::size_t data = bytes.find ("DATA binary_compressed\n") + 23;
  for (const std::size_t size :
       {data + 2, data + 8, data + 200, data + (bytes.size() - data) / 2}) {
    writeFile (folder ("cut.pcd"), bytes.substr (0, size));
    expectIoError (
        [&] { io::readOrganizedCloud (folder ("cut.pcd")); }, "cut.pcd", "points");
  }
}

TEST (Clouds, AFolderOfCloudsNeedsNoCameraFile)
{
  const TemporaryFolder folder;
  pcl::io::savePCDFileBinary (folder ("cloud_0.pcd"), wall<pcl::PointXYZ>());
  const io::DataFolder data (folder (""));
  ASSERT_EQ (data.frames(), 1);
  EXPECT_NEAR (data.frame (0).camera.fx, kCamera.fx, 1e-3);
}

} // namespace
