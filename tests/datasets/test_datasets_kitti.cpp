// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/compare_images.h"
#include "support/disparity_writers.h"
#include "support/expect_io_error.h"
#include <pcl_msf/io/datasets.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;
using io::openDataset;

constexpr double kBaseline = 0.54;

class Kitti : public ::testing::Test {
protected:
  void
  SetUp () override
  {
    writeKitti (smallSequence(), temporary_ ("training"), kBaseline);
  }

  std::string
  file (const std::string& name) const
  {
    return temporary_ ("training/" + name);
  }

  std::shared_ptr<const io::RgbdSequence>
  open () const
  {
    return openDataset (io::DatasetKind::Kitti2015, temporary_ ("")).front();
  }

  TemporaryFolder temporary_;
};

TEST_F (Kitti, ReadsFramesAndCamera)
{
  const SyntheticSequence& made = smallSequence();
  const auto sequence =
      openDataset (io::DatasetKind::Automatic, temporary_ ("")).front();
  EXPECT_EQ (sequence->name(), "000007");
  ASSERT_EQ (sequence->frames(), 2);
  const double fb = made.camera.fx * kBaseline;
  for (int k = 0; k < 2; ++k) {
    const io::RgbdImages images = sequence->frame (k);
    EXPECT_EQ (cv::norm (images.color, made.frames[k].color, cv::NORM_INF), 0.0);
    EXPECT_NEAR (images.camera.fx, made.camera.fx, 1e-9);
    EXPECT_NEAR (images.camera.cy, made.camera.cy, 1e-9);
    // Half a 256th of a pixel at 5 m.
    expectSame (images.depth, made.frames[k].depth, 25.0 / fb / 500.0, 5000);
  }
}

TEST_F (Kitti, ReadsTruth)
{
  const SyntheticSequence& made = smallSequence();
  const io::MotionTruth truth = open()->truth (0, 1);
  expectSame (truth.flow, made.truth[1].flow, 0.5 / 64.0 + 1e-5, 5000);
  expectSame (truth.scene_flow, made.truth[1].scene_flow, 0.05, 5000);
  EXPECT_EQ (agreement (truth.visible, made.truth[1].visible), 1.0);
  EXPECT_EQ (cv::countNonZero (truth.labels != made.labels), 0);
  EXPECT_TRUE (open()->truth (1, 0).flow.empty());
}

TEST_F (Kitti, AsksForDenseDisparities)
{
  std::filesystem::remove (file ("disp_1/000007_11.png"));
  expectIoError ([&] { open()->frame (1); }, "disp_1/000007_11.png", "disparity");
  EXPECT_NO_THROW (open()->frame (0));
  // Methods that write both frames into one folder, as floats.
  putPfm (file ("disp_0/000007_11.pfm"), cv::Mat (72, 96, CV_32FC1, 8.0));
  const io::RgbdImages images = open()->frame (1);
  EXPECT_NEAR (
      images.depth.at<float> (4, 4), smallSequence().camera.fx * kBaseline / 8.0, 1e-5);
}

TEST_F (Kitti, NamesWhatIsDamaged)
{
  putImage (file ("disp_occ_1/000007_10.png"), cv::Mat (72, 90, CV_16UC1, 300.0));
  expectIoError ([&] { open()->truth (0, 1); }, "disp_occ_1", "width, height");
  putImage (file ("flow_noc/000007_10.png"), cv::Mat (72, 96, CV_8UC3, 3.0));
  expectIoError ([&] { open()->truth (0, 1); }, "flow_noc/000007_10.png", "flow");
  const std::string image = file ("disp_0/000007_10.png");
  putText (image, readFile (image).substr (0, 60));
  expectIoError ([&] { open()->frame (0); }, "disp_0/000007_10.png", "depth");
  std::filesystem::remove (file ("image_2/000007_11.png"));
  expectIoError ([&] { open()->frame (1); }, "image_2/000007_11.png", "no such file");
  const std::string calibration = file ("calib_cam_to_cam/000007.txt");
  putText (calibration, "P_rect_02: 80 0 48 0 0 80 36 0 0 0 1 0\n");
  expectIoError ([&] { open(); }, "000007.txt", "P_rect_03");
  putText (calibration,
           "P_rect_02: 80 0 48 0 0 80 36 0 0 0 1\nP_rect_03: 80 0 48 0 0 80\n");
  expectIoError ([&] { open(); }, "000007.txt: line 1", "P_rect_02");
  std::filesystem::remove (calibration);
  expectIoError ([&] { open(); }, "calib_cam_to_cam/000007.txt", "no such file");
}

} // namespace
