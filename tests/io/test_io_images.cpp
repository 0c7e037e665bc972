// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <boost/crc.hpp>

#include <opencv2/imgcodecs.hpp>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

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
  EXPECT_EQ (depth.at<float> (0, 2), 0.0F) << "saturated";
}

TEST (Images, FloatDepthIsMetresUnlessItsScaleIsGiven)
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
  for (const char* name : {"d.tiff", "d.pfm", "d.DPT"}) {
    const cv::Mat depth = io::readDepth (folder (name), 1000.0, 500.0);
    EXPECT_FLOAT_EQ (depth.at<float> (1, 1), 0.007F) << name;
  }
}

TEST (Images, DepthRoundTripDropsWhatIsNoMeasurement)
{
  const TemporaryFolder folder;
  const cv::Mat depth = (cv::Mat_<float> (1, 4) << 1.234F, kNan, 65.535F, 1e6F);
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
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 1;
  writeFile (folder ("damaged.png"), damaged);
  expectIoError (
      [&] { io::readColor (folder ("damaged.png")); }, "damaged.png", "checksum");
  std::string huge = bytes;
  huge.replace (16, 8, std::string ("\x3B\x9A\xCA\0\x3B\x9A\xCA\0", 8));
  boost::crc_32_type checksum;
  checksum.process_bytes (huge.data() + 12, 17);
  for (int i = 0; i < 4; ++i)
    huge[29 + i] = static_cast<char> (checksum.checksum() >> (24 - 8 * i));
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

/** Infrared and ToF cameras fill any part of 16 bits. */
TEST (Images, DeepGreyKeepsWhatEightBitsWouldDrop)
{
  const TemporaryFolder folder;
  const auto row = [] (std::uint16_t bright) {
    cv::Mat image (1, 40, CV_16UC1, cv::Scalar (bright));
    image.at<std::uint16_t> (0, 0) = 0;
    image.at<std::uint16_t> (0, 1) = 100;
    return image;
  };
  const cv::Mat dark = row (400), light = row (800);
  cv::imwrite (folder ("a.png"), dark);
  cv::imwrite (folder ("b.png"), light);
  io::RgbdImages a, b;
  io::readColor (folder ("a.png"), a);
  io::readColor (folder ("b.png"), b);
  io::unifyColors ({&a, &b});
  EXPECT_EQ (a.color.at<cv::Vec3b> (0, 1), b.color.at<cv::Vec3b> (0, 1));
  EXPECT_GT (a.color.at<cv::Vec3b> (0, 1)[0], 20);
  EXPECT_LT (a.color.at<cv::Vec3b> (0, 2)[0], b.color.at<cv::Vec3b> (0, 2)[0]);
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

} // namespace
