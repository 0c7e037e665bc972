// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_io.h>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
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

const PinholeCamera kCamera{50.0, 48.0, 19.0, 14.5};

/** A flat wall at 2 m as the camera sees it, one point missing. */
template <typename PointT>
pcl::PointCloud<PointT>
wall ()
{
  pcl::PointCloud<PointT> cloud (40, 30);
  for (int row = 0; row < 30; ++row)
    for (int col = 0; col < 40; ++col) {
      const Eigen::Vector3f p = kCamera.backProject (col, row, 2.0).cast<float>();
      cloud (col, row).getVector3fMap() = p;
    }
  cloud (3, 4).getVector3fMap().setConstant (std::numeric_limits<float>::quiet_NaN());
  cloud.is_dense = false;
  return cloud;
}

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

/** A header of 40x30 points with fields after x y z, and the points' bytes. */
class HandMadeCloud {
public:
  HandMadeCloud (const std::string& fields,
                 const std::string& sizes,
                 const std::string& types,
                 const std::string& counts)
  : bytes_ ("VERSION .7\nFIELDS x y z " + fields + "\nSIZE 4 4 4 " + sizes +
            "\nTYPE F F F " + types + "\nCOUNT 1 1 1 " + counts +
            "\nWIDTH 40\nHEIGHT 30\nPOINTS 1200\nDATA binary\n")
  {}

  /** Every point has the same numbers but the first, which is black. */
  template <typename T>
  HandMadeCloud&
  points (const std::vector<T>& numbers)
  {
    bool first = true;
    for (const auto& point : wall<pcl::PointXYZ>()) {
      bytes_.append (reinterpret_cast<const char*> (point.data), 12);
      for (const T number : numbers) {
        const T value = first ? T{} : number;
        bytes_.append (reinterpret_cast<const char*> (&value), sizeof (T));
      }
      first = false;
    }
    return *this;
  }
  const std::string&
  bytes () const
  {
    return bytes_;
  }

private:
  std::string bytes_;
};

class CloudDialects : public ::testing::Test {
protected:
  io::RgbdImages
  read (const HandMadeCloud& cloud, const char* name = "a.pcd") const
  {
    writeFile (folder_ (name), cloud.bytes());
    return io::readCloudImages (folder_ (name), kCamera);
  }
  void
  expectColor (const HandMadeCloud& cloud, const cv::Vec3b& bgr) const
  {
    const io::RgbdImages images = read (cloud);
    ASSERT_EQ (images.color.type(), CV_8UC3) << cloud.bytes().substr (0, 120);
    EXPECT_EQ (images.color.at<cv::Vec3b> (7, 7), bgr) << cloud.bytes().substr (0, 120);
    EXPECT_EQ (images.color.at<cv::Vec3b> (0, 0), cv::Vec3b (0, 0, 0));
    EXPECT_EQ (images.note, "");
    const auto points = io::readOrganizedCloud (folder_ ("a.pcd"));
    EXPECT_EQ ((*points) (7, 7).r, bgr[2]);
    EXPECT_EQ ((*points) (7, 7).a, 255);
  }

  TemporaryFolder folder_;
};

TEST_F (CloudDialects, ColoursInNumbersOfTheirOwn)
{
  const cv::Vec3b bgr (10, 120, 255);
  const auto bytes = [] (const std::string& names) {
    return HandMadeCloud (names, "1 1 1", "U U U", "1 1 1")
        .points<std::uint8_t> ({255, 120, 10});
  };
  expectColor (bytes ("r g b"), bgr);
  expectColor (bytes ("Red Green Blue"), bgr);
  expectColor (HandMadeCloud ("b g r", "1 1 1", "U U U", "1 1 1")
                   .points<std::uint8_t> ({10, 120, 255}),
               bgr);
  expectColor (HandMadeCloud ("red green blue", "4 4 4", "F F F", "1 1 1")
                   .points<float> ({255.0F, 120.0F, 10.0F}),
               bgr);
  expectColor (HandMadeCloud ("r g b", "8 8 8", "F F F", "1 1 1")
                   .points<double> ({1.0, 120.0 / 255.0, 10.0 / 255.0}),
               bgr);
  expectColor (HandMadeCloud ("r g b", "4 4 4", "I I I", "1 1 1")
                   .points<std::int32_t> ({255, 120, 10}),
               bgr);
  expectColor (HandMadeCloud ("red green blue", "2 2 2", "U U U", "1 1 1")
                   .points<std::uint16_t> ({65535, 120 * 257, 10 * 257}),
               bgr);
  expectColor (
      HandMadeCloud ("rgb", "1", "U", "3").points<std::uint8_t> ({255, 120, 10}), bgr);
}

TEST_F (CloudDialects, BytesAreNotTakenForAShareOfOne)
{
  expectColor (HandMadeCloud ("intensity", "1", "U", "1").points<std::uint8_t> ({1}),
               cv::Vec3b (1, 1, 1));
}

TEST_F (CloudDialects, IntensitiesOfFramesThatAreComparedGetOneUnit)
{
  const auto cloud = [] (float intensity) {
    return HandMadeCloud ("intensity", "4", "F", "1").points<float> ({intensity});
  };
  const auto gray = [] (const io::RgbdImages& images) {
    return images.color.at<cv::Vec3b> (7, 7)[0];
  };
  io::RgbdImages dark = read (cloud (0.5F)), light = read (cloud (102.0F), "b.pcd");
  io::unifyColors ({&dark, &light});
  EXPECT_LE (gray (dark), 1) << "0.5 of 255";
  EXPECT_EQ (gray (light), 102);
  dark = read (cloud (2000.0F));
  light = read (cloud (4000.0F), "b.pcd");
  EXPECT_NEAR (gray (dark), 249, 1) << "alone, of 2047";
  io::unifyColors ({&dark, &light});
  EXPECT_NEAR (gray (dark), 124.5, 1.0) << "of 4095";
  EXPECT_NEAR (gray (light), 249, 1);
}

TEST_F (CloudDialects, PaddingMayHaveNoValues)
{
  const io::RgbdImages images = read (
      HandMadeCloud ("rgb _", "4 1", "U U", "1 0").points<std::uint32_t> ({0x0A0B0C}));
  EXPECT_EQ (images.color.at<cv::Vec3b> (7, 7), cv::Vec3b (0x0C, 0x0B, 0x0A));
  EXPECT_NEAR (images.depth.at<float> (7, 7), 2.0F, 1e-6);
}

TEST_F (CloudDialects, SaysWhichFieldsHoldNoColour)
{
  const io::RgbdImages images =
      read (HandMadeCloud ("ring", "2", "U", "1").points<std::uint16_t> ({3}));
  EXPECT_TRUE (images.color.empty());
  EXPECT_EQ (images.note, "no colour found (fields x y z ring): geometry alone");
}

TEST_F (CloudDialects, AByteOrderMarkIsNoPartOfTheHeader)
{
  pcl::PCDWriter().writeASCII (folder_ ("plain.pcd"), wall<pcl::PointXYZ>());
  writeFile (folder_ ("mark.pcd"), "\xEF\xBB\xBF" + readFile (folder_ ("plain.pcd")));
  const io::RgbdImages images = io::readCloudImages (folder_ ("mark.pcd"), kCamera);
  EXPECT_NEAR (images.depth.at<float> (29, 39), 2.0F, 1e-5);
  const HandMadeCloud binary =
      HandMadeCloud ("ring", "2", "U", "1").points<std::uint16_t> ({3});
  writeFile (folder_ ("edited.pcd"), "\xEF\xBB\xBF" + binary.bytes());
  expectIoError ([&] { io::readOrganizedCloud (folder_ ("edited.pcd")); },
                 "edited.pcd",
                 "encoding");
}

TEST_F (CloudDialects, MillimetresBecomeMetres)
{
  auto cloud = wall<pcl::PointXYZ>();
  for (auto& point : cloud)
    point.getVector3fMap() *= 1000.0F;
  pcl::io::savePCDFileBinary (folder_ ("mm.pcd"), cloud);
  const io::RgbdImages images = io::readCloudImages (folder_ ("mm.pcd"), {}, 1000.0);
  EXPECT_NEAR (images.depth.at<float> (7, 7), 2.0F, 1e-5);
  EXPECT_NEAR (images.camera.fx, kCamera.fx, 1e-3);
  EXPECT_THROW (io::readCloudImages (folder_ ("mm.pcd"), {}, 0.0), InvalidInput);
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
