// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/expect_io_error.h"
#include "support/format_bytes.h"
#include <pcl_msf/io/datasets.h>

#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using io::openDataset;

constexpr int kWidth = 90;
constexpr int kHeight = 24;
constexpr int kBack = 4;   // pixels of disparity
constexpr int kFront = 10; // of the patch, columns 40 .. 59 of the left view

/** A wall with a patch in front of it, as either view has it. */
cv::Mat
disparities (bool left)
{
  const int first = left ? 40 : 40 - kFront;
  cv::Mat d (kHeight, kWidth, CV_32FC1, cv::Scalar (kBack));
  d (cv::Rect (first, 5, 20, 10)).setTo (kFront);
  d.at<float> (0, 20) = std::numeric_limits<float>::infinity();
  return d;
}

/** 2003's: grey, 4 levels a pixel, 0 = unknown. */
cv::Mat
greyDisparities (bool left)
{
  const cv::Mat d = disparities (left);
  cv::Mat grey (d.size(), CV_8UC1);
  for (int row = 0; row < d.rows; ++row)
    for (int col = 0; col < d.cols; ++col) {
      const float value = d.at<float> (row, col);
      grey.at<unsigned char> (row, col) =
          std::isfinite (value) ? static_cast<unsigned char> (4.0F * value) : 0;
    }
  return grey;
}

void
write2003 (const std::string& folder)
{
  putImage (folder + "/im2.ppm", cv::Mat (kHeight, kWidth, CV_8UC3, 50.0));
  putImage (folder + "/im6.ppm", cv::Mat (kHeight, kWidth, CV_8UC3, 60.0));
  putImage (folder + "/disp2.pgm", greyDisparities (true));
  putImage (folder + "/disp6.pgm", greyDisparities (false));
}

const char* const kCalibration = "cam0=[200 0 40.5; 0 200 11.5; 0 0 1]\n"
                                 "cam1=[200 0 46.5; 0 200 11.5; 0 0 1]\n"
                                 "doffs=6\nbaseline=150\nwidth=90\nheight=24\n"
                                 "ndisp=16\nisint=0\nvmin=4\nvmax=10\n";

void
write2014 (const std::string& folder)
{
  putImage (folder + "/im0.png", cv::Mat (kHeight, kWidth, CV_8UC3, 50.0));
  putImage (folder + "/im1.png", cv::Mat (kHeight, kWidth, CV_8UC3, 60.0));
  putPfm (folder + "/disp0.pfm", disparities (true));
  putPfm (folder + "/disp1.pfm", disparities (false));
  putText (folder + "/calib.txt", kCalibration);
}

TEST (Middlebury, MakesAMovingCameraOfThePairsOf2003)
{
  const TemporaryFolder folder;
  write2003 (folder ("cones"));
  const auto sequence = openDataset (io::DatasetKind::Automatic, folder ("")).front();
  EXPECT_EQ (sequence->name(), "cones");
  ASSERT_EQ (sequence->frames(), 2);
  const io::RgbdImages left = sequence->frame (0), right = sequence->frame (1);
  EXPECT_DOUBLE_EQ (left.camera.fx, 100.0);
  EXPECT_DOUBLE_EQ (left.camera.cx, 44.5);
  EXPECT_EQ (right.camera.cx, left.camera.cx);
  EXPECT_EQ (right.color.at<cv::Vec3b> (2, 2)[0], 60);
  // z = f b / d = 100 x 0.1 / d
  EXPECT_FLOAT_EQ (left.depth.at<float> (10, 45), 1.0F);
  EXPECT_FLOAT_EQ (left.depth.at<float> (20, 45), 2.5F);
  EXPECT_FLOAT_EQ (right.depth.at<float> (10, 35), 1.0F);
  EXPECT_TRUE (std::isnan (left.depth.at<float> (0, 20)));
  const io::MotionTruth truth = sequence->truth (0, 1);
  EXPECT_EQ (truth.flow.at<cv::Vec2f> (10, 45), cv::Vec2f (-10.0F, 0.0F));
  EXPECT_TRUE (std::isnan (truth.flow.at<cv::Vec2f> (0, 20)[0]));
  for (const int col : {45, 80}) {
    const auto moved = truth.scene_flow.at<cv::Vec3f> (10, col);
    EXPECT_NEAR (moved[0], -0.1, 1e-6);
    EXPECT_NEAR (moved[1], 0.0, 1e-6);
    EXPECT_NEAR (moved[2], 0.0, 1e-6);
  }
  ASSERT_TRUE (truth.rigid);
  EXPECT_DOUBLE_EQ (truth.rigid->translation().x(), -0.1);
}

TEST (Middlebury, TellsByBothViewsWhatIsHidden)
{
  const TemporaryFolder folder;
  write2003 (folder ("cones"));
  const auto sequence =
      openDataset (io::DatasetKind::Middlebury, folder ("cones")).front();
  const cv::Mat visible = sequence->truth (0, 1).visible;
  const auto seen = [&visible] (int row, int col) {
    return visible.at<unsigned char> (row, col) == 255;
  };
  EXPECT_TRUE (seen (10, 40));
  EXPECT_TRUE (seen (10, 59));
  // The patch moves 6 pixels further than the wall: it hides columns 34 to 39.
  EXPECT_TRUE (seen (10, 33));
  for (int col = 34; col < 40; ++col)
    EXPECT_FALSE (seen (10, col)) << col;
  EXPECT_TRUE (seen (10, 60));
  for (int col = 0; col < kBack; ++col)
    EXPECT_FALSE (seen (20, col)) << "leaves the image";
  EXPECT_FALSE (seen (0, 20));
  // From the right view the wall is hidden on the other side.
  const io::MotionTruth back = sequence->truth (1, 0);
  EXPECT_EQ (back.flow.at<cv::Vec2f> (10, 35), cv::Vec2f (10.0F, 0.0F));
  EXPECT_EQ (back.visible.at<unsigned char> (10, 50), 0);
  EXPECT_EQ (back.visible.at<unsigned char> (10, 56), 255);
  EXPECT_DOUBLE_EQ (back.rigid->translation().x(), 0.1);
}

TEST (Middlebury, ReadsTheCalibrationOf2014)
{
  const TemporaryFolder folder;
  write2014 (folder ("Pipes"));
  const auto sequence = openDataset (io::DatasetKind::Automatic, folder ("")).front();
  const io::RgbdImages left = sequence->frame (0), right = sequence->frame (1);
  EXPECT_EQ (left.camera.fx, 200.0);
  EXPECT_EQ (left.camera.cx, 40.5);
  EXPECT_EQ (right.camera.cx, 46.5);
  // z = f b / (d + doffs) = 30 / 16 and 30 / 10
  EXPECT_FLOAT_EQ (left.depth.at<float> (10, 45), 1.875F);
  EXPECT_FLOAT_EQ (right.depth.at<float> (20, 45), 3.0F);
  const auto moved = sequence->truth (0, 1).scene_flow.at<cv::Vec3f> (10, 45);
  EXPECT_NEAR (moved[0], -0.15, 1e-6);
  EXPECT_NEAR (moved[2], 0.0, 1e-6);
  ASSERT_TRUE (sequence->cameraPose (1));
  EXPECT_DOUBLE_EQ (sequence->cameraPose (1)->translation().x(), 0.15);
}

TEST (Middlebury, NamesWhatIsDamaged)
{
  const TemporaryFolder folder;
  write2003 (folder ("old"));
  write2014 (folder ("new"));
  const auto old = openDataset (io::DatasetKind::Middlebury, folder ("old")).front();
  const auto recent = openDataset (io::DatasetKind::Middlebury, folder ("new")).front();
  const auto open = [&] { openDataset (io::DatasetKind::Middlebury, folder ("new")); };
  std::filesystem::remove (folder ("old/disp6.pgm"));
  expectIoError ([&] { old->frame (1); }, "disp6", "no such file");
  putImage (folder ("old/im2.ppm"), cv::Mat (kHeight, 80, CV_8UC3, 50.0));
  expectIoError ([&] { old->frame (0); }, "im2.ppm", "width, height");
  putPfm (folder ("new/disp1.pfm"), cv::Mat (kHeight, kWidth, CV_32FC3, 1.0));
  expectIoError ([&] { recent->frame (1); }, "disp1.pfm", "disparity");
  putPfm (folder ("new/disp1.pfm"), disparities (false));
  putPfm (folder ("new/disp0.pfm"), cv::Mat (kHeight, 80, CV_32FC1, 1.0));
  expectIoError ([&] { recent->truth (0, 1); }, "disp0.pfm", "width, height");
  putText (folder ("new/calib.txt"), "cam0=[200 0 40.5; 0 200 11.5; 0 0 1]\n");
  expectIoError (open, "calib.txt", "cam1");
  std::string text = kCalibration;
  putText (folder ("new/calib.txt"), text.replace (text.find ("150"), 3, "abc"));
  expectIoError (open, "calib.txt", "baseline: 'abc'");
  putText (folder ("new/calib.txt"), "cam0=[200 0 40.5; 0 200 11.5; 0 0]\n");
  expectIoError (open, "calib.txt", "cam0: 8 numbers where 9");
}

} // namespace
