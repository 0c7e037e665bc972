// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "expect_io_error.h"
#include "support/compare_images.h"
#include "support/dataset_writers.h"
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/synthetic/sequence_writer.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using io::openDataset;

void
expectSamePose (const std::optional<RigidPose>& actual, const RigidPose& expected)
{
  ASSERT_TRUE (actual);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR (actual->parameters[i], expected.parameters[i], 1e-5);
}

void
expectSameColor (const cv::Mat& actual, const cv::Mat& expected)
{
  ASSERT_EQ (actual.type(), expected.type());
  EXPECT_EQ (cv::norm (actual, expected, cv::NORM_INF), 0.0);
}

io::DatasetOptions
withCamera ()
{
  io::DatasetOptions options;
  options.camera = smallSequence().camera;
  return options;
}

class Sintel : public ::testing::Test {
protected:
  void
  SetUp () override
  {
    SequenceWriterOptions options;
    options.layout = SequenceLayout::Sintel;
    options.name = "alley_1";
    writeSequence (smallSequence(), top_ + "/training", options);
  }

  std::string
  file (const std::string& kind, const std::string& name) const
  {
    return top_ + "/training/" + kind + "/alley_1/" + name;
  }

  TemporaryFolder temporary_;
  const std::string top_ = temporary_ ("sintel");
};

TEST_F (Sintel, ReadsFramesCamerasAndTruth)
{
  const SyntheticSequence& made = smallSequence();
  for (const std::string path : {"", "/training", "/training/clean/alley_1"}) {
    const auto sequences = openDataset ("sintel", top_ + path);
    ASSERT_EQ (sequences.size(), 1u);
    EXPECT_EQ (sequences[0]->name(), "alley_1");
    EXPECT_EQ (sequences[0]->frames(), 3);
  }
  const auto sequence = openDataset ("auto", top_).front();
  const io::RgbdImages images = sequence->frame (1);
  expectSameColor (images.color, made.frames[1].color);
  expectSame (images.depth, made.frames[1].depth, 0.0, 5000, true);
  EXPECT_EQ (images.camera.fx, made.camera.fx);
  EXPECT_EQ (images.camera.cy, made.camera.cy);
  expectSamePose (sequence->cameraPose (2), made.frame0_from_framek[2]);
  EXPECT_TRUE (std::isnan (sequence->timestamp (0)));
  const io::MotionTruth truth = sequence->truth (1, 2);
  expectSame (truth.flow, made.successive_truth[1].flow, 0.0, 5000);
  EXPECT_EQ (agreement (truth.visible, made.successive_truth[1].visible), 1.0);
  EXPECT_TRUE (truth.scene_flow.empty());
  EXPECT_TRUE (sequence->truth (0, 2).flow.empty());
  EXPECT_THROW (sequence->truth (2, 3), InvalidInput);
}

TEST_F (Sintel, ChoosesTheRendering)
{
  io::DatasetOptions options;
  options.pass = "final";
  expectIoError ([&] { openDataset ("sintel", top_, options); }, "sintel", "sequences");
  putImage (file ("final", "frame_0001.png"), cv::Mat (72, 96, CV_8UC3, 7.0));
  const auto final = openDataset ("sintel", top_, options).front();
  ASSERT_EQ (final->frames(), 1);
  EXPECT_EQ (final->frame (0).color.at<cv::Vec3b> (3, 4)[0], 7);
  const auto by_path = openDataset ("sintel", top_ + "/training/final/alley_1/");
  EXPECT_EQ (by_path.front()->frames(), 1);
}

TEST_F (Sintel, HasNoTruthAcrossAGap)
{
  std::filesystem::remove (file ("clean", "frame_0002.png"));
  const auto sequence = openDataset ("sintel", top_).front();
  ASSERT_EQ (sequence->frames(), 2);
  EXPECT_TRUE (sequence->truth (0, 1).flow.empty());
}

TEST_F (Sintel, NamesWhatIsDamaged)
{
  const auto frame = [&] { openDataset ("sintel", top_).front()->frame (0); };
  const auto truth = [&] { openDataset ("sintel", top_).front()->truth (0, 1); };
  putTagged (file ("flow", "frame_0001.flo"), cv::Mat (70, 96, CV_32FC2, 1.0));
  expectIoError (truth, "frame_0001.flo", "width, height");
  putTagged (file ("depth", "frame_0001.dpt"), cv::Mat (70, 96, CV_32FC1, 1.0));
  expectIoError (frame, "frame_0001.png", "width, height");
  putText (file ("depth", "frame_0001.dpt"), "PIEG0123456789");
  expectIoError (frame, "frame_0001.dpt", "magic number");
  std::filesystem::remove (file ("depth", "frame_0001.dpt"));
  expectIoError (frame, "frame_0001.dpt", "no such file");
  const std::string cam = file ("camdata_left", "frame_0002.cam");
  const std::string bytes = readFile (cam);
  putText (cam, bytes.substr (0, 100));
  expectIoError (frame, "frame_0002.cam", "extrinsic matrix");
  putText (cam, bytes.substr (0, 50));
  expectIoError (frame, "frame_0002.cam", "intrinsic matrix");
  putText (cam, "PIEX" + bytes.substr (4));
  expectIoError (frame, "frame_0002.cam", "magic number");
  putText (cam, bytes + "x");
  expectIoError (frame, "frame_0002.cam", "end");
  std::string scaled = bytes;
  const double two = 2.0;
  std::memcpy (&scaled[4 + 72], &two, sizeof (two));
  putText (cam, scaled);
  expectIoError (frame, "frame_0002.cam", "extrinsic matrix");
  std::filesystem::remove (cam);
  expectIoError (frame, "frame_0002.cam", "no such file");
}

TEST (VirtualKitti1, ReadsFramesPosesAndFlow)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeVirtualKitti1 (made, folder ("vkitti"));
  const auto sequences = openDataset ("vkitti1", folder ("vkitti"), withCamera());
  ASSERT_EQ (sequences.size(), 1u);
  EXPECT_EQ (sequences[0]->name(), "0001/clone");
  ASSERT_EQ (sequences[0]->frames(), 3);
  const io::RgbdImages images = sequences[0]->frame (1);
  expectSameColor (images.color, made.frames[1].color);
  expectSame (images.depth, made.frames[1].depth, 0.00501, 5000, true);
  expectSamePose (sequences[0]->cameraPose (1), made.frame0_from_framek[1]);
  const io::MotionTruth truth = sequences[0]->truth (0, 1);
  expectSame (truth.flow, made.successive_truth[0].flow, 95.0 / 65535.0 + 1e-5, 5000);
  EXPECT_EQ (openDataset ("auto", folder ("vkitti/vkitti_1.3.1_rgb/0001"), withCamera())
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
  const auto images = openDataset ("auto", folder ("")).front()->frame (0);
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
    return openDataset ("vkitti1", folder (""), withCamera()).front();
  };
  expectIoError ([&] { openDataset ("vkitti1", folder ("")).front()->frame (0); },
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
    const auto sequences = openDataset ("auto", folder ("data"));
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
  const auto sequence = openDataset ("vkitti2", folder ("")).front();
  ASSERT_EQ (sequence->frames(), 2);
  expectSame (sequence->frame (0).depth, made.frames[1].depth, 0.00501, 5000, true);
  expectSamePose (sequence->cameraPose (1), made.frame0_from_framek[2]);
  expectSame (sequence->truth (0, 1).flow, made.successive_truth[1].flow, 0.002, 5000);
}

TEST (VirtualKitti2, NamesWhatIsDamaged)
{
  const TemporaryFolder folder;
  writeVirtualKitti2 (smallSequence(), folder (""), false);
  const auto open = [&] { return openDataset ("vkitti2", folder ("")).front(); };
  const std::string frames = folder ("Scene01/clone/frames");
  putImage (frames + "/forwardSceneFlow/Camera_0/sceneFlow_00000.png",
            cv::Mat (72, 96, CV_16UC1, 9.0));
  expectIoError ([&] { open()->truth (0, 1); }, "sceneFlow_00000.png", "scene flow");
  std::filesystem::remove (frames + "/depth/Camera_0/depth_00001.png");
  expectIoError ([&] { open()->frame (1); }, "depth_00001.png", "no such file");
  const std::string intrinsic = folder ("Scene01/clone/intrinsic.txt");
  putText (intrinsic, "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n0 0 80 80 48\n");
  expectIoError (open, "intrinsic.txt: line 2", "K[1,2]: missing");
  putText (intrinsic, "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n0 0 80 80 48 36\n");
  expectIoError (open, "intrinsic.txt", "frame 1 of camera 0");
  std::filesystem::remove (intrinsic);
  expectIoError (open, "intrinsic.txt", "no such file");
}

TEST (FlyingThings, ReadsFramesPosesAndSceneFlow)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeFlyingThings (made, folder ("data"));
  for (const std::string path : {"data", "data/frames_cleanpass/TRAIN/A/0000"}) {
    const auto sequences = openDataset ("auto", folder (path), withCamera());
    ASSERT_EQ (sequences.size(), 1u);
    EXPECT_EQ (sequences[0]->name(), "TRAIN/A/0000");
  }
  const auto sequence = openDataset ("flyingthings", folder ("data"), withCamera())[0];
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
  options.pass = "final";
  auto sequences = openDataset ("flyingthings", folder (""), options);
  ASSERT_EQ (sequences.size(), 2u);
  EXPECT_EQ (sequences[0]->name(), "15mm_focallength/scene_backwards/fast");
  EXPECT_EQ (sequences[0]->frame (0).camera.fx, 450.0);
  EXPECT_FLOAT_EQ (sequences[0]->frame (0).depth.at<float> (5, 5), 45.0F);
  EXPECT_EQ (sequences[1]->frame (0).camera.fx, 1050.0);
  EXPECT_EQ (sequences[1]->frame (0).camera.cx, 479.5);
  EXPECT_FLOAT_EQ (sequences[1]->frame (0).depth.at<float> (5, 5), 105.0F);
  options.view = "right";
  sequences = openDataset ("flyingthings", folder (""), options);
  EXPECT_FLOAT_EQ (sequences[1]->frame (0).depth.at<float> (5, 5), 52.5F);
}

TEST (FlyingThings, NamesWhatIsDamaged)
{
  const TemporaryFolder folder;
  writeFlyingThings (smallSequence(), folder (""));
  const auto open = [&] {
    return openDataset ("flyingthings", folder (""), withCamera()).front();
  };
  expectIoError ([&] { openDataset ("flyingthings", folder (""))[0]->frame (0); },
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
