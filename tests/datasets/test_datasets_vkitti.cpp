// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/compare_images.h"
#include "support/expect_io_error.h"
#include "support/virtual_kitti_writers.h"
#include <pcl_msf/io/datasets.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;
using io::openDataset;

TEST (VirtualKitti1, ReadsFramesPosesAndFlow)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeVirtualKitti1 (made, folder ("vkitti"));
  const auto sequences =
      openDataset (io::DatasetKind::VirtualKitti1, folder ("vkitti"), withCamera());
  ASSERT_EQ (sequences.size(), 1u);
  EXPECT_EQ (sequences[0]->name(), "0001/clone");
  ASSERT_EQ (sequences[0]->frames(), 3);
  const io::RgbdImages images = sequences[0]->frame (1);
  expectSameColor (images.color, made.frames[1].color);
  expectSame (images.depth, made.frames[1].depth, 0.00501, 5000, true);
  expectSamePose (sequences[0]->cameraPose (1), made.frame0_from_framek[1]);
  const io::MotionTruth truth = sequences[0]->truth (0, 1);
  expectSame (truth.flow, made.successive_truth[0].flow, 95.0 / 65535.0 + 1e-5, 5000);
  EXPECT_EQ (openDataset (io::DatasetKind::Automatic,
                          folder ("vkitti/vkitti_1.3.1_rgb/0001"),
                          withCamera())
                 .size(),
             1u);
}

TEST (VirtualKitti1, HasThePublishedCameraAndNoDepthInTheSky)
{
  const TemporaryFolder folder;
  cv::Mat depth (375, 1242, CV_16UC1, cv::Scalar (1234));
  depth.row (0).setTo (65535);
  putImage (folder ("vkitti_1.3.1_rgb/0002/fog/00000.png"),
            cv::Mat (375, 1242, CV_8UC3, 9.0));
  putImage (folder ("vkitti_1.3.1_depthgt/0002/fog/00000.png"), depth);
  const auto images =
      openDataset (io::DatasetKind::Automatic, folder ("")).front()->frame (0);
  EXPECT_EQ (images.camera.fx, 725.0);
  EXPECT_EQ (images.camera.cx, 620.5);
  EXPECT_EQ (images.camera.cy, 187.0);
  EXPECT_FLOAT_EQ (images.depth.at<float> (9, 9), 12.34F);
  EXPECT_EQ (images.depth.at<float> (0, 9), 0.0F);
}

TEST (VirtualKitti1, NamesWhatIsDamaged)
{
  const TemporaryFolder folder;
  writeVirtualKitti1 (smallSequence(), folder (""));
  const auto open = [&] {
    return openDataset (io::DatasetKind::VirtualKitti1, folder (""), withCamera())
        .front();
  };
  expectIoError (
      [&] {
        openDataset (io::DatasetKind::VirtualKitti1, folder ("")).front()->frame (0);
      },
      "00000.png",
      "1242x375");
  const std::string flow = folder ("vkitti_1.3.1_flowgt/0001/clone/00000.png");
  putImage (flow, cv::Mat (72, 96, CV_8UC3, 9.0));
  expectIoError ([&] { open()->truth (0, 1); }, "flowgt/0001/clone/00000.png", "flow");
  putImage (flow, cv::Mat (72, 90, CV_16UC3, 9.0));
  expectIoError ([&] { open()->truth (0, 1); }, "00000.png", "width, height");
  const std::string depth = folder ("vkitti_1.3.1_depthgt/0001/clone/00001.png");
  putText (depth, readFile (depth).substr (0, 200));
  expectIoError ([&] { open()->frame (1); }, "00001.png", "depth");
  std::filesystem::remove (depth);
  expectIoError ([&] { open()->frame (1); }, "00001.png", "no such file");
  putText (folder ("vkitti_1.3.1_extrinsicsgt/0001_clone.txt"),
           "frame r1,1\n0 1 0 0 0 0 1 0 0 0 0 one 0 0 0 0 1\n");
  expectIoError (open, "0001_clone.txt: line 2", "matrix element 3,3");
}

TEST (VirtualKitti2, ReadsFramesPosesAndSceneFlow)
{
  const SyntheticSequence& made = smallSequence();
  for (const bool archives : {false, true}) {
    const TemporaryFolder folder;
    writeVirtualKitti2 (made, folder ("data"), archives);
    const auto sequences = openDataset (io::DatasetKind::Automatic, folder ("data"));
    ASSERT_EQ (sequences.size(), 1u);
    EXPECT_EQ (sequences[0]->name(), "Scene01/clone");
    ASSERT_EQ (sequences[0]->frames(), 3);
    const io::RgbdImages images = sequences[0]->frame (2);
    EXPECT_LT (cv::norm (images.color, made.frames[2].color, cv::NORM_L1) /
                   static_cast<double> (images.color.total() * 3),
               8.0); // JPEG
    expectSame (images.depth, made.frames[2].depth, 0.00501, 5000, true);
    EXPECT_NEAR (images.camera.cx, made.camera.cx, 1e-9);
    expectSamePose (sequences[0]->cameraPose (2), made.frame0_from_framek[2]);
    const io::MotionTruth truth = sequences[0]->truth (1, 2);
    const GroundTruth& exact = made.successive_truth[1];
    expectSame (truth.flow, exact.flow, 95.0 / 65535.0 + 1e-5, 5000);
    expectSame (truth.scene_flow, exact.scene_flow, 10.0 / 65535.0 + 1e-5, 5000);
    EXPECT_GT (agreement (truth.visible, exact.visible), 0.97);
    EXPECT_TRUE (sequences[0]->truth (2, 1).flow.empty());
  }
}

TEST (VirtualKitti2, CountsFramesByTheirNames)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeVirtualKitti2 (made, folder (""), false);
  const std::string color = folder ("Scene01/clone/frames/rgb/Camera_0/rgb_00000.jpg");
  std::filesystem::remove (color);
  const auto sequence =
      openDataset (io::DatasetKind::VirtualKitti2, folder ("")).front();
  ASSERT_EQ (sequence->frames(), 2);
  expectSame (sequence->frame (0).depth, made.frames[1].depth, 0.00501, 5000, true);
  expectSamePose (sequence->cameraPose (1), made.frame0_from_framek[2]);
  expectSame (sequence->truth (0, 1).flow, made.successive_truth[1].flow, 0.002, 5000);
}

TEST (VirtualKitti2, NamesWhatIsDamaged)
{
  const TemporaryFolder folder;
  writeVirtualKitti2 (smallSequence(), folder (""), false);
  const auto open = [&] {
    return openDataset (io::DatasetKind::VirtualKitti2, folder ("")).front();
  };
  const std::string frames = folder ("Scene01/clone/frames");
  putImage (frames + "/forwardSceneFlow/Camera_0/sceneFlow_00000.png",
            cv::Mat (72, 96, CV_16UC1, 9.0));
  expectIoError ([&] { open()->truth (0, 1); }, "sceneFlow_00000.png", "scene flow");
  std::filesystem::remove (frames + "/depth/Camera_0/depth_00001.png");
  expectIoError ([&] { open()->frame (1); }, "depth_00001.png", "no such file");
  const std::string color = frames + "/rgb/Camera_0/rgb_00000.jpg";
  const std::string bytes = readFile (color);
  putText (color, bytes.substr (0, bytes.size() / 2));
  expectIoError ([&] { open()->frame (0); }, "rgb_00000.jpg", "colour");
  const std::string intrinsic = folder ("Scene01/clone/intrinsic.txt");
  putText (intrinsic, "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n0 0 80 80 48\n");
  expectIoError (open, "intrinsic.txt: line 2", "K[1,2]: missing");
  putText (intrinsic, "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n0 0 80 80 48 36\n");
  expectIoError (open, "intrinsic.txt", "frame 1 of camera 0");
  std::filesystem::remove (intrinsic);
  expectIoError (open, "intrinsic.txt", "no such file");
}

} // namespace
