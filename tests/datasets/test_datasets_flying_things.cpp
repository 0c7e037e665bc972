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

TEST (FlyingThings, ReadsFramesPosesAndSceneFlow)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeFlyingThings (made, folder ("data"));
  for (const std::string path : {"data", "data/frames_cleanpass/TRAIN/A/0000"}) {
    const auto sequences =
        openDataset (io::DatasetKind::Automatic, folder (path), withCamera());
    ASSERT_EQ (sequences.size(), 1u);
    EXPECT_EQ (sequences[0]->name(), "TRAIN/A/0000");
  }
  const auto sequence =
      openDataset (io::DatasetKind::FlyingThings, folder ("data"), withCamera())[0];
  ASSERT_EQ (sequence->frames(), 3);
  const io::RgbdImages images = sequence->frame (1);
  expectSameColor (images.color, made.frames[1].color);
  expectSame (images.depth, made.frames[1].depth, 1e-5, 5000);
  expectSamePose (sequence->cameraPose (1), made.frame0_from_framek[1]);
  const io::MotionTruth truth = sequence->truth (1, 2);
  const GroundTruth& exact = made.successive_truth[1];
  expectSame (truth.flow, exact.flow, 0.0, 5000);
  expectSame (truth.scene_flow, exact.scene_flow, 1e-4, 5000);
  EXPECT_GT (agreement (truth.visible, exact.visible), 0.97);
}

TEST (FlyingThings, HasThePublishedCameras)
{
  const TemporaryFolder folder;
  for (const std::string name :
       {"treeflight_x2", "15mm_focallength/scene_backwards/fast"})
    for (const std::string view : {"left", "right"}) {
      const std::string end = "/" + name + "/" + view + "/0001";
      putImage (folder ("frames_finalpass" + end + ".png"),
                cv::Mat (540, 960, CV_8UC3, 9.0));
      putPfm (folder ("disparity" + end + ".pfm"),
              cv::Mat (540, 960, CV_32FC1, view == "left" ? 10.0 : -20.0));
    }
  io::DatasetOptions options;
  options.pass = io::RenderPass::Final;
  auto sequences = openDataset (io::DatasetKind::FlyingThings, folder (""), options);
  ASSERT_EQ (sequences.size(), 2u);
  EXPECT_EQ (sequences[0]->name(), "15mm_focallength/scene_backwards/fast");
  EXPECT_EQ (sequences[0]->frame (0).camera.fx, 450.0);
  EXPECT_FLOAT_EQ (sequences[0]->frame (0).depth.at<float> (5, 5), 45.0F);
  EXPECT_EQ (sequences[1]->frame (0).camera.fx, 1050.0);
  EXPECT_EQ (sequences[1]->frame (0).camera.cx, 479.5);
  EXPECT_FLOAT_EQ (sequences[1]->frame (0).depth.at<float> (5, 5), 105.0F);
  options.view = io::StereoView::Right;
  sequences = openDataset (io::DatasetKind::FlyingThings, folder (""), options);
  EXPECT_FLOAT_EQ (sequences[1]->frame (0).depth.at<float> (5, 5), 52.5F);
}

TEST (FlyingThings, NamesWhatIsDamaged)
{
  const TemporaryFolder folder;
  writeFlyingThings (smallSequence(), folder (""));
  const auto open = [&] {
    return openDataset (io::DatasetKind::FlyingThings, folder (""), withCamera())
        .front();
  };
  expectIoError (
      [&] { openDataset (io::DatasetKind::FlyingThings, folder (""))[0]->frame (0); },
      "0006.pfm",
      "960x540");
  const std::string change =
      folder ("disparity_change/TRAIN/A/0000/into_future/left/0006.pfm");
  putPfm (change, cv::Mat (72, 96, CV_32FC3, 9.0));
  expectIoError ([&] { open()->truth (0, 1); }, "0006.pfm", "disparity change");
  putPfm (change, cv::Mat (72, 95, CV_32FC1, 9.0));
  expectIoError ([&] { open()->truth (0, 1); }, "0006.pfm", "width, height");
  putText (change, readFile (change).substr (0, 400));
  expectIoError ([&] { open()->truth (0, 1); }, "0006.pfm", "pixels");
  putPfm (folder ("optical_flow/TRAIN/A/0000/into_future/left/"
                  "OpticalFlowIntoFuture_0006_L.pfm"),
          cv::Mat (72, 96, CV_32FC1, 9.0));
  expectIoError (
      [&] { open()->truth (0, 1); }, "OpticalFlowIntoFuture_0006_L.pfm", "flow");
  std::filesystem::remove (folder ("disparity/TRAIN/A/0000/left/0007.pfm"));
  expectIoError ([&] { open()->frame (1); }, "0007.pfm", "no such file");
  const std::string poses = folder ("camera_data/TRAIN/A/0000/camera_data.txt");
  putText (poses, "Frame 6\nL 1 0 0\n");
  expectIoError (open, "camera_data.txt: line 2", "matrix element 1,4");
  putText (poses, "Frame 6\nX 1 0 0\n");
  expectIoError (open, "camera_data.txt: line 2", "Frame, L or R");
}

} // namespace
