// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "io/datasets/middlebury_files.h"
#include "support/format_bytes.h"
#include "support/literal_bytes.h"
#include <pcl_msf/io/datasets.h>

#include <cmath>

// Tiny scenes of the Middlebury data sets, spelled byte by byte from their
// descriptions: a reader and the tests' writers that misread a format in the same way
// fail here.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

std::shared_ptr<const io::RgbdSequence>
opened (const std::string& folder)
{
  return io::openDataset (io::DatasetKind::Middlebury, folder).front();
}

// 2003, quarter size: views 2 (left) and 6 (right); disp2 says how far to the left a
// pixel of im2 lies in im6, in grey levels of 1/4 pixel, 0 = unknown.
class Middlebury2003Bytes : public ::testing::Test {
protected:
  Middlebury2003Bytes()
  {
    const std::string grey = bytes ("\x40\x40\x40");
    std::string row;
    for (int column = 1; column < 9; ++column)
      row += grey;
    putText (folder_ ("im2.ppm"),
             "P6\n9 1\n255\n"
             "\xFF\x80\x10" + // red 255, green 128, blue 16
                 row);
    putText (folder_ ("im6.ppm"), "P6\n9 1\n255\n" + row + grey);
    putText (folder_ ("disp2.pgm"),
             bytes ("P5\n9 1\n255\n"
                    "\x06"             // column 0: 1.5 pixels
                    "\x04\x04\x04\x04" // columns 1 to 4, the wall: 1 pixel
                    "\x0C\x0C"         // columns 5 and 6, in front of it: 3 pixels
                    "\x04"             // column 7: the wall
                    "\0"));            // column 8: unknown
    putText (folder_ ("disp6.pgm"),
             bytes ("P5\n9 1\n255\n"
                    "\0"                      // column 0: unknown
                    "\x04"                    // column 1: the wall
                    "\x0C\x0C"                // columns 2 and 3: what is in front
                    "\x04\x04\x04\x04\x04")); // columns 4 to 8: the wall
  }

  const TemporaryFolder folder_;
};

TEST_F (Middlebury2003Bytes, Frames)
{
  const auto sequence = opened (folder_ (""));
  ASSERT_EQ (sequence->frames(), 2);
  const io::RgbdImages left = sequence->frame (0);
  ASSERT_EQ (left.color.size(), cv::Size (9, 1));
  EXPECT_EQ (left.color.at<cv::Vec3b> (0, 0), cv::Vec3b (16, 128, 255));
  // z = f b / d with f = 10 / 9 of nine columns, b = 0.1 m
  EXPECT_FLOAT_EQ (left.depth.at<float> (0, 0), 1.0F / 1.5F);
  EXPECT_FLOAT_EQ (left.depth.at<float> (0, 1), 1.0F);
  EXPECT_FLOAT_EQ (left.depth.at<float> (0, 5), 1.0F / 3.0F);
  EXPECT_TRUE (std::isnan (left.depth.at<float> (0, 8)));
  const cv::Mat right = sequence->frame (1).depth;
  EXPECT_TRUE (std::isnan (right.at<float> (0, 0)));
  EXPECT_FLOAT_EQ (right.at<float> (0, 2), 1.0F / 3.0F);
}

TEST_F (Middlebury2003Bytes, Motion)
{
  const auto sequence = opened (folder_ (""));
  const io::MotionTruth there = sequence->truth (0, 1);
  EXPECT_EQ (there.flow.at<cv::Vec2f> (0, 0), cv::Vec2f (-1.5F, 0.0F));
  EXPECT_EQ (there.flow.at<cv::Vec2f> (0, 5), cv::Vec2f (-3.0F, 0.0F));
  const auto seen = [] (const io::MotionTruth& truth) {
    std::string text;
    for (int column = 0; column < 9; ++column)
      text += truth.visible.at<unsigned char> (0, column) != 0 ? '+' : '-';
    return text;
  };
  EXPECT_EQ (seen (there),
             "-" // leaves the image
             "-" // comes to where the other view knows nothing
             "+"
             "--" // behind what comes to columns 2 and 3
             "++"
             "+"
             "-"); // unknown
  const io::MotionTruth back = sequence->truth (1, 0);
  EXPECT_EQ (back.flow.at<cv::Vec2f> (0, 2), cv::Vec2f (3.0F, 0.0F));
  EXPECT_EQ (seen (back),
             "-" // unknown
             "+"
             "++"
             "--" // behind what comes to columns 5 and 6
             "+"
             "-"   // comes to where the other view knows nothing
             "-"); // leaves the image
}

// The example of the data set's description: cam0, cam1 = [f 0 cx; 0 f cy; 0 0 1],
// doffs = the difference of cx, baseline in mm.
TEST (Middlebury2014Bytes, Calibration)
{
  const TemporaryFolder folder;
  putText (folder ("im0.png"), ""); // is there
  putText (folder ("calib.txt"),
           "cam0=[3997.684 0 1176.728; 0 3997.684 1011.728; 0 0 1]\n"
           "cam1=[3997.684 0 1307.839; 0 3997.684 1011.728; 0 0 1]\n"
           "doffs=131.111\n"
           "baseline=193.001\n"
           "width=2964\nheight=1988\nndisp=280\nisint=0\nvmin=31\nvmax=257\n"
           "dyavg=0.918\ndymax=1.516\n");
  const io::MiddleburyPair pair = io::findMiddlebury (folder (""));
  EXPECT_EQ (pair.camera[0].fx, 3997.684);
  EXPECT_EQ (pair.camera[0].fy, 3997.684);
  EXPECT_EQ (pair.camera[0].cx, 1176.728);
  EXPECT_EQ (pair.camera[1].cx, 1307.839);
  EXPECT_EQ (pair.camera[1].cy, 1011.728);
  EXPECT_NEAR (pair.camera[1].cx - pair.camera[0].cx, pair.offset, 1e-9);
  EXPECT_DOUBLE_EQ (pair.baseline, 0.193001);
  EXPECT_FALSE (pair.disparity_scale) << "disparities are pixels";
}

// disp0.pfm: "Pf", one channel, a negative scale: little-endian; the lowest row first,
// inf = unknown. z = baseline f / (d + doffs).
TEST (Middlebury2014Bytes, Scene)
{
  const TemporaryFolder folder;
  putText (folder ("calib.txt"),
           "cam0=[2 0 1; 0 2 0.5; 0 0 1]\ncam1=[2 0 1.5; 0 2 0.5; 0 0 1]\n"
           "doffs=0.5\nbaseline=250\nwidth=3\nheight=2\n");
  const std::string size = bytes ("\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR"
                                  "\0\0\0\x03\0\0\0\x02"   // three by two pixels
                                  "\x08\x02\0\0\0"         // 8 bits of red, green, blue
                                  "\x12\x16\xF1\x4D"       // checksum
                                  "\0\0\0\x1FIDAT\x78\x01" // 31 bytes
                                  "\x01\x14\0\xEB\xFF");   // stored: 20 bytes
  const std::string end = bytes ("\0\0\0\0IEND\xAE\x42\x60\x82");
  putText (folder ("im0.png"),
           size +
               bytes ("\0"
                      "\xFF\0\0\0\xFF\0\0\0\xFF" // red, green, blue
                      "\0"
                      "\x10\x20\x30\x10\x20\x30\x10\x20\x30" // below
                      "\x32\x27\x04\x1E\x39\x0F\xA9\xE8") +  // checksums
               end);
  putText (folder ("im1.png"),
           size +
               bytes ("\0\x40\0\0\x40\0\0\x40\0\0" // dark red
                      "\0\x40\0\0\x40\0\0\x40\0\0"
                      "\x10\x94\x01\x81\x40\xE4\xF0\x7C") +
               end);
  putText (folder ("disp0.pfm"),
           bytes ("Pf\n3 2\n-1\n"
                  "\0\0\0\x3F\0\0\xC0\x3F\0\0\x80\x7F" // below: 0.5, 1.5, inf
                  "\0\0\0\x40\0\0\0\x40\0\0\0\x40"));  // above: 2, 2, 2
  putText (folder ("disp1.pfm"),
           bytes ("Pf\n3 2\n-1\n"
                  "\0\0\x80\x7F\0\0\x80\x7F\0\0\0\x3F" // below: inf, inf, 0.5
                  "\0\0\0\x40\0\0\0\x40\0\0\0\x40"));  // above: 2, 2, 2
  const auto sequence = opened (folder (""));
  const io::RgbdImages left = sequence->frame (0);
  EXPECT_EQ (left.color.at<cv::Vec3b> (0, 0), cv::Vec3b (0, 0, 255)) << "red";
  EXPECT_EQ (left.color.at<cv::Vec3b> (1, 2), cv::Vec3b (48, 32, 16));
  EXPECT_FLOAT_EQ (left.depth.at<float> (0, 0), 0.2F);
  EXPECT_FLOAT_EQ (left.depth.at<float> (1, 0), 0.5F);
  EXPECT_FLOAT_EQ (left.depth.at<float> (1, 1), 0.25F);
  EXPECT_TRUE (std::isnan (left.depth.at<float> (1, 2)));
  EXPECT_FLOAT_EQ (sequence->frame (1).depth.at<float> (1, 2), 0.5F);
  const io::MotionTruth truth = sequence->truth (0, 1);
  EXPECT_EQ (truth.flow.at<cv::Vec2f> (1, 1), cv::Vec2f (-1.5F, 0.0F));
  const auto moved = truth.scene_flow.at<cv::Vec3f> (1, 1);
  EXPECT_NEAR (moved[0], -0.25, 1e-6) << "the baseline";
  EXPECT_NEAR (moved[2], 0.0, 1e-6);
  EXPECT_EQ (truth.visible.at<unsigned char> (0, 2), 255) << "comes to column 0";
  EXPECT_EQ (truth.visible.at<unsigned char> (0, 1), 0) << "leaves the image";
}

} // namespace
