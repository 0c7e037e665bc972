// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include "support/wall_cloud.h"
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/point_files.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

// Clouds as other programs write them.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

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
    const io::PointFile list = io::readPoints (folder_ ("a.pcd"));
    ASSERT_EQ (list.colors.size(), 1200U);
    EXPECT_EQ (list.colors[0], 0U);
    EXPECT_EQ (list.colors[1],
               std::uint32_t{bgr[2]} << 16U | std::uint32_t{bgr[1]} << 8U | bgr[0]);
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
  io::RgbdImages dark = read (cloud (1.0F)), light = read (cloud (102.0F), "b.pcd");
  io::unifyColors ({&dark, &light});
  EXPECT_LE (gray (dark), 1) << "1 of 255";
  EXPECT_EQ (gray (light), 102);
  dark = read (cloud (2000.0F));
  light = read (cloud (4000.0F), "b.pcd");
  EXPECT_NEAR (gray (dark), 249, 1) << "alone, of 2047";
  io::unifyColors ({&dark, &light});
  EXPECT_NEAR (gray (dark), 124.5, 1.0) << "of 4095";
  EXPECT_NEAR (gray (light), 249, 1);
  dark = read (cloud (0.5F));
  EXPECT_THROW (io::unifyColors ({&dark, &light}), InvalidInput) << "two units";
}

TEST_F (CloudDialects, CloudsReadTogetherHaveOneUnit)
{
  const auto cloud = [] (float intensity) {
    return HandMadeCloud ("intensity", "4", "F", "1").points<float> ({intensity});
  };
  writeFile (folder_ ("a.pcd"), cloud (0.9F).bytes());
  writeFile (folder_ ("b.pcd"), cloud (1.8F).bytes());
  const auto clouds = io::readOrganizedClouds ({folder_ ("a.pcd"), folder_ ("b.pcd")});
  ASSERT_EQ (clouds.size(), 2U);
  EXPECT_NEAR (2 * (*clouds[0]) (7, 7).g, (*clouds[1]) (7, 7).g, 1);
  EXPECT_TRUE (io::readOrganizedClouds ({}).empty());
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

TEST_F (CloudDialects, AnyNameWillDo)
{
  const HandMadeCloud cloud =
      HandMadeCloud ("ring", "2", "U", "1").points<std::uint16_t> ({3});
  const TemporaryFolder temporary;
  const char* before = std::getenv ("TMPDIR");
  const std::string kept = before ? before : "";
  setenv ("TMPDIR", temporary ("").c_str(), 1);
  for (const char* name : {"a.PCD", "a.bin", "a"})
    EXPECT_NEAR (read (cloud, name).depth.at<float> (29, 39), 2.0F, 1e-5) << name;
  EXPECT_EQ (filesIn (temporary ("")), 0U) << "copies are removed";
  setenv ("TMPDIR", temporary ("not_there").c_str(), 1);
  EXPECT_NEAR (read (cloud, "a.pcd").depth.at<float> (29, 39), 2.0F, 1e-5);
  expectIoError ([&] { read (cloud, "a.bin"); }, "a.bin", "points");
  if (before)
    setenv ("TMPDIR", kept.c_str(), 1);
  else
    unsetenv ("TMPDIR");
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

/** Header and rows are compared; blank lines, Windows' ends and none are well. */
TEST_F (CloudDialects, TextPlyHasTheRowsThatItsHeaderCounts)
{
  const auto read = [this] (const std::string& rows) {
    writeFile (folder_ ("a.ply"),
               "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty "
               "float y\nproperty float z\nelement face 1\nproperty list uchar int "
               "vertex_indices\nend_header\n" +
                   rows);
    return io::readPoints (folder_ ("a.ply")).points;
  };
  const auto refused = [&read] (const std::string& rows, const std::string& words) {
    expectIoError ([&] { read (rows); }, "a.ply", words);
  };
  for (const char* rows : {"1 2 3\n4 5 6\n3 0 1 1\n",
                           "1 2 3\n4 5 6\n3 0 1 1\n\n \n",
                           "\n 1\t2 3\r\n\n4 5 6 \r\n3 0 1 1\r\n",
                           "1 2 3\n4 5 6"}) {
    const auto points = read (rows);
    ASSERT_EQ (points.size(), 2U) << rows;
    EXPECT_EQ (points[1], Eigen::Vector3f (4, 5, 6)) << rows;
  }
  refused ("1 2 3\n4 5", "row 2: the file ends too early");
  refused ("1 2 3\n", "row 2: the file ends too early");
  refused ("1 2\n3 4 5\n3 0 1 1\n", "row 1: has 2 numbers, the header counts 3");
  refused ("1 2 3\n4 5 6 7\n3 0 1 1\n", "row 2: has 4 numbers");
  refused ("1 2 3\n4 5 x\n3 0 1 1\n", "row 2: 'x' is no number");
  refused ("1 2 3\n4 5 6\n7 8 9\n3 0 1 1\n", "row 4: the header counts 3 rows");
}

// Wavefront's Appendix B1; colours as MeshLab, Blender and others write them.
TEST_F (CloudDialects, ObjWithWeightsAndColours)
{
  const auto colors = [this] (const std::string& vertices) {
    writeFile (folder_ ("a.obj"),
               "# by hand\nmtllib a.mtl\n" + vertices + "vn 0 0 1\nf 1 1 1\n");
    const io::PointFile file = io::readPoints (folder_ ("a.obj"));
    EXPECT_EQ (file.points.front(), Eigen::Vector3f (1.5F, -2.0F, 3.0F)) << vertices;
    return file.colors;
  };
  using Colors = std::vector<std::uint32_t>;
  EXPECT_EQ (colors ("v 1.5 -2 3\n"), Colors{});
  EXPECT_EQ (colors ("v 1.5 -2 3 1.0 # a weight\r\n"), Colors{});
  EXPECT_EQ (colors ("v 1.5 -2 3 1 0.2 0\nv 0 0 1 0 0 0.6\n"),
             (Colors{0xFF3300U, 0x000099U}));
  EXPECT_EQ (colors ("v 1.5 -2 3 200 20 10\nv 0 0 1 0 1 0\n"),
             (Colors{0xC8140AU, 0x000100U}));
  EXPECT_EQ (colors ("v 1.5 -2 3 1 0 1 0.5\n"), Colors{0xFF00FFU}) << "with alpha";
  EXPECT_EQ (colors ("v 1.5 -2 3 nan 1 0\nv 0 0 1\n"), (Colors{0x00FF00U, 0xFFFFFFU}))
      << "white without a colour";
  expectIoError ([&] { colors ("v 1.5 -2 3 red\n"); }, "a.obj", "'red' is no number");
  expectIoError ([&] { colors ("v 1.5 -2\n"); }, "a.obj", "2 numbers");
}

} // namespace
