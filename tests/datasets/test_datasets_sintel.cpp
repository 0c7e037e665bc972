// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/compare_images.h"
#include "support/expect_io_error.h"
#include "support/format_bytes.h"
#include "support/small_sequence.h"
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/synthetic/sequence_writer.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;
using io::openDataset;

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
    const auto sequences = openDataset (io::DatasetKind::Sintel, top_ + path);
    ASSERT_EQ (sequences.size(), 1u);
    EXPECT_EQ (sequences[0]->name(), "alley_1");
    EXPECT_EQ (sequences[0]->frames(), 3);
  }
  const auto sequence = openDataset (io::DatasetKind::Automatic, top_).front();
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

TEST_F (Sintel, TakesBothMasksForHidden)
{
  for (const char* kind : {"occlusions", "invalid"}) {
    cv::Mat mask (72, 96, CV_8UC1, cv::Scalar (0));
    mask.at<unsigned char> (36, kind[0] == 'o' ? 40 : 50) = 255;
    putImage (file (kind, "frame_0001.png"), mask);
  }
  const io::MotionTruth truth =
      openDataset (io::DatasetKind::Sintel, top_).front()->truth (0, 1);
  EXPECT_EQ (truth.visible.at<unsigned char> (36, 40), 0);
  EXPECT_EQ (truth.visible.at<unsigned char> (36, 50), 0);
  EXPECT_EQ (truth.visible.at<unsigned char> (36, 45), 255);
  EXPECT_TRUE (std::isfinite (truth.flow.at<cv::Vec2f> (36, 50)[0]));
}

TEST_F (Sintel, ChoosesTheRendering)
{
  io::DatasetOptions options;
  options.pass = io::RenderPass::Final;
  expectIoError ([&] { openDataset (io::DatasetKind::Sintel, top_, options); },
                 "sintel",
                 "sequences");
  putImage (file ("final", "frame_0001.png"), cv::Mat (72, 96, CV_8UC3, 7.0));
  const auto final = openDataset (io::DatasetKind::Sintel, top_, options).front();
  ASSERT_EQ (final->frames(), 1);
  EXPECT_EQ (final->frame (0).color.at<cv::Vec3b> (3, 4)[0], 7);
  const auto by_path =
      openDataset (io::DatasetKind::Sintel, top_ + "/training/final/alley_1/");
  EXPECT_EQ (by_path.front()->frames(), 1);
}

TEST_F (Sintel, HasNoTruthAcrossAGap)
{
  std::filesystem::remove (file ("clean", "frame_0002.png"));
  const auto sequence = openDataset (io::DatasetKind::Sintel, top_).front();
  ASSERT_EQ (sequence->frames(), 2);
  EXPECT_TRUE (sequence->truth (0, 1).flow.empty());
}

TEST_F (Sintel, NamesWhatIsDamaged)
{
  const auto frame = [&] {
    openDataset (io::DatasetKind::Sintel, top_).front()->frame (0);
  };
  const auto truth = [&] {
    openDataset (io::DatasetKind::Sintel, top_).front()->truth (0, 1);
  };
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

} // namespace
