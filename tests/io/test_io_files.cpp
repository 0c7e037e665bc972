// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/float_files.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

const float kNan = std::numeric_limits<float>::quiet_NaN();

template <typename T>
std::string
bytesOf (T value)
{
  std::string bytes (sizeof (T), '\0');
  std::memcpy (bytes.data(), &value, sizeof (T));
  return bytes;
}

/** The head of a .flo or .dpt file, its magic number spelled as bytes. */
std::string
taggedHead (std::int32_t width, std::int32_t height)
{
  return "PIEH" + bytesOf (width) + bytesOf (height);
}

TEST (FlowFile, HasThePublishedBytes)
{
  const TemporaryFolder folder;
  const cv::Mat flow =
      (cv::Mat_<cv::Vec2f> (1, 2) << cv::Vec2f (1.5F, -2.0F), cv::Vec2f (kNan, 0.0F));
  io::writeFlow (folder ("a.flo"), flow);
  EXPECT_EQ (readFile (folder ("a.flo")),
             taggedHead (2, 1) + bytesOf (1.5F) + bytesOf (-2.0F) + bytesOf (1e10F) +
                 bytesOf (1e10F));
}

TEST (FlowFile, ReadsHandMadeBytesAndMarksUnknown)
{
  const TemporaryFolder folder;
  writeFile (folder ("a.flo"),
             taggedHead (1, 2) + bytesOf (3.0F) + bytesOf (4.0F) + bytesOf (1.0F) +
                 bytesOf (2e9F));
  const cv::Mat flow = io::readFlow (folder ("a.flo"));
  ASSERT_EQ (flow.size(), cv::Size (1, 2));
  EXPECT_EQ (flow.at<cv::Vec2f> (0, 0), cv::Vec2f (3.0F, 4.0F));
  EXPECT_TRUE (std::isnan (flow.at<cv::Vec2f> (1, 0)[0]));
  EXPECT_TRUE (std::isnan (flow.at<cv::Vec2f> (1, 0)[1]));
}

TEST (FlowFile, RefusesMalformedFiles)
{
  const TemporaryFolder folder;
  const auto read = [&] (const std::string& bytes) {
    return [&folder, bytes] {
      writeFile (folder ("bad.flo"), bytes);
      io::readFlow (folder ("bad.flo"));
    };
  };
  expectIoError (read (""), "bad.flo", "magic number");
  expectIoError (read ("JUNKJUNKJUNK"), "bad.flo", "magic number");
  expectIoError (read ("PIEH"), "bad.flo", "width");
  expectIoError (read (taggedHead (0, 5)), "bad.flo", "width");
  expectIoError (read (taggedHead (-3, 5)), "bad.flo", "width");
  expectIoError (read (taggedHead (1000000000, 1000000000)), "bad.flo", "width");
  expectIoError (read (taggedHead (4, 4) + "short"), "bad.flo", "pixels");
  expectIoError (
      [&] { io::readFlow (folder ("none.flo")); }, "none.flo", "no such file");
  expectIoError ([&] { io::readFlow (folder ("")); }, folder (""), "not a file");
}

TEST (FlowFile, LeavesNothingBehindWhenItCannotBeWritten)
{
  const TemporaryFolder folder;
  const cv::Mat flow (2, 2, CV_32FC2, cv::Scalar::all (1));
  expectIoError ([&] { io::writeFlow (folder ("no/such/a.flo"), flow); },
                 "a.flo",
                 "cannot be written");
  std::filesystem::create_directory (folder ("taken.flo"));
  expectIoError ([&] { io::writeFlow (folder ("taken.flo"), flow); },
                 "taken.flo",
                 "cannot be written");
  expectIoError ([&] { io::writeFlow (folder ("a.flo"), cv::Mat()); }, "a.flo", "flow");
  EXPECT_EQ (pcl_msf::testing::filesIn (folder ("")), 1U);
}

TEST (DptFile, HasThePublishedBytesAndRoundTrips)
{
  const TemporaryFolder folder;
  const cv::Mat depth = (cv::Mat_<float> (2, 1) << 1.25F, 1e8F);
  io::writeDpt (folder ("a.dpt"), depth);
  EXPECT_EQ (readFile (folder ("a.dpt")),
             taggedHead (1, 2) + bytesOf (1.25F) + bytesOf (1e8F));
  EXPECT_EQ (cv::countNonZero (io::readDpt (folder ("a.dpt")) != depth), 0);
}

TEST (PfmFile, RowsRunFromTheBottomInEitherByteOrder)
{
  const TemporaryFolder folder;
  writeFile (folder ("little.pfm"),
             "Pf\n1 2\n-1.0\n" + bytesOf (7.0F) + bytesOf (8.0F));
  writeFile (folder ("big.pfm"),
             std::string ("Pf 1 2 1\n") + std::string ("\x40\xE0\0\0\x41\0\0\0", 8));
  for (const char* name : {"little.pfm", "big.pfm"}) {
    const cv::Mat image = io::readPfm (folder (name));
    ASSERT_EQ (image.type(), CV_32FC1);
    EXPECT_EQ (image.at<float> (0, 0), 8.0F) << name;
    EXPECT_EQ (image.at<float> (1, 0), 7.0F) << name;
  }
}

TEST (PfmFile, ColourRoundTripKeepsTheChannelOrder)
{
  const TemporaryFolder folder;
  const cv::Mat image =
      (cv::Mat_<cv::Vec3f> (1, 2) << cv::Vec3f (1, 2, 3), cv::Vec3f (4, 5, 6));
  io::writePfm (folder ("a.pfm"), image);
  EXPECT_EQ (readFile (folder ("a.pfm")).substr (0, 17),
             "PF\n2 1\n-1\n" + bytesOf (1.0F) + bytesOf (2.0F).substr (0, 3));
  const cv::Mat back = io::readPfm (folder ("a.pfm"));
  EXPECT_EQ (cv::norm (back, image, cv::NORM_INF), 0.0);
}

TEST (PfmFile, RefusesMalformedFiles)
{
  const TemporaryFolder folder;
  const auto read = [&] (const std::string& bytes) {
    return [&folder, bytes] {
      writeFile (folder ("bad.pfm"), bytes);
      io::readPfm (folder ("bad.pfm"));
    };
  };
  expectIoError (read (""), "bad.pfm", "type");
  expectIoError (read ("P6\n1 1\n255\n"), "bad.pfm", "type");
  expectIoError (read ("Pf\nwide 1\n-1\n"), "bad.pfm", "width");
  expectIoError (read ("Pf\n1"), "bad.pfm", "width");
  expectIoError (read ("Pf\n1 1\n0\n0000"), "bad.pfm", "scale");
  expectIoError (read ("Pf\n999999999 999999999\n-1\n"), "bad.pfm", "width");
  expectIoError (read ("Pf\n99999999999 1\n-1\n"), "bad.pfm", "width");
  expectIoError (read ("Pf\n8 8\n-1\nshort"), "bad.pfm", "pixels");
}

} // namespace
