// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/file_lists.h"
#include "io/datasets/truth_parts.h"
#include "support/compare_images.h"
#include "support/expect_io_error.h"
#include "support/format_bytes.h"
#include "support/pose_matcher.h"
#include "support/small_sequence.h"
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/synthetic/sequence_writer.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;
using io::openDataset;

TEST (Datasets, ListTheirKinds)
{
  const std::vector<std::string> expected{"cases",
                                          "tum",
                                          "sintel",
                                          "vkitti1",
                                          "vkitti2",
                                          "flyingthings",
                                          "kitti2015",
                                          "middlebury",
                                          "folder",
                                          "bonn",
                                          "pcd"};
  std::vector<std::string> names;
  for (const auto& [name, kind] : io::datasetKinds()) {
    names.push_back (name);
    EXPECT_EQ (io::datasetKindFromName (name), kind);
  }
  EXPECT_EQ (names, expected);
  EXPECT_EQ (io::datasetKindFromName ("auto"), io::DatasetKind::Automatic);
}

TEST (Datasets, SayWhatIsNotThere)
{
  const TemporaryFolder folder;
  EXPECT_THROW (io::datasetKindFromName ("nuscenes"), InvalidInput);
  expectIoError (
      [&] { openDataset (io::DatasetKind::Tum, folder ("none")); }, "none", "path");
  for (const auto& known : io::datasetKinds())
    if (known.first != "bonn") // another name of "folder"
      expectIoError ([&] { openDataset (known.second, folder ("")); },
                     "'" + known.first + "'",
                     "sequences");
  expectIoError ([&] { openDataset (io::DatasetKind::Automatic, folder ("")); },
                 folder (""),
                 "kind");
}

TEST (Datasets, RefuseOptionsOutOfRange)
{
  const TemporaryFolder folder;
  const auto refuses = [&] (const auto& change) {
    io::DatasetOptions options;
    change (options);
    EXPECT_THROW (openDataset (io::DatasetKind::Automatic, folder (""), options),
                  InvalidInput);
  };
  refuses ([] (auto& o) { o.depth_scale = 0.0; });
  refuses ([] (auto& o) { o.depth_scale = std::numeric_limits<double>::infinity(); });
  refuses ([] (auto& o) { o.max_time_difference = 0.0; });
}

TEST (Datasets, ADepthScaleCountsOrIsRefused)
{
  const TemporaryFolder folder;
  SequenceWriterOptions written;
  writeSequence (smallSequence(), folder ("case"), written); // as floats, in metres
  io::DatasetOptions options;
  options.depth_scale = 500.0;
  const cv::Mat metres =
      openDataset (io::DatasetKind::Cases, folder ("case"))[0]->frame (0).depth;
  const cv::Mat scaled =
      openDataset (io::DatasetKind::Cases, folder ("case"), options)[0]
          ->frame (0)
          .depth;
  EXPECT_FLOAT_EQ (scaled.at<float> (40, 40), metres.at<float> (40, 40) / 500.0F);
  EXPECT_FALSE (
      openDataset (io::DatasetKind::Cases, folder ("case"))[0]->definesDepthUnit());
  written.layout = SequenceLayout::Sintel;
  writeSequence (smallSequence(), folder ("training"), written);
  for (const io::DatasetKind kind :
       {io::DatasetKind::Sintel, io::DatasetKind::Automatic})
    try {
      EXPECT_TRUE (openDataset (kind, folder ("training"))[0]->definesDepthUnit());
      openDataset (kind, folder ("training"), options);
      ADD_FAILURE() << static_cast<int> (kind);
    }
    catch (const InvalidInput& e) {
      EXPECT_THAT (e.what(), ::testing::HasSubstr ("depth_scale: 500 is not for"));
    }
}

TEST (Datasets, OpenByTheNameOfTheirKindToo)
{
  const TemporaryFolder folder;
  writeSequence (smallSequence(), folder ("case"));
  for (const char* name : {"cases", "auto"})
    EXPECT_EQ (io::openDataset (name, folder ("case")).size(), 1U);
  EXPECT_THROW (io::openDataset ("csaes", folder ("case")), InvalidInput);
}

TEST (Datasets, AskForTheKindWhenTwoFit)
{
  const TemporaryFolder folder;
  writeSequence (smallSequence(), folder ("case"));
  putText (folder ("room/rgb.txt"), "1.0 rgb/1.png\n");
  putText (folder ("room/depth.txt"), "1.0 depth/1.png\n");
  expectIoError ([&] { openDataset (io::DatasetKind::Automatic, folder ("")); },
                 folder (""),
                 "cases, tum");
  EXPECT_EQ (openDataset (io::DatasetKind::Tum, folder ("")).front()->name(), "room");
  EXPECT_EQ (openDataset (io::DatasetKind::Cases, folder ("")).front()->name(), "case");
}

TEST (Datasets, TellWhyTheOneThatFitsIsDamaged)
{
  const TemporaryFolder folder;
  putText (folder ("rgb.txt"), "now rgb/1.png\n");
  expectIoError ([&] { openDataset (io::DatasetKind::Automatic, folder ("")); },
                 "rgb.txt",
                 "timestamp");
}

TEST (Datasets, SortNumbersByValue)
{
  std::vector<std::string> names{"a10", "b1", "a2", "a02b", "a", "a1x3", "a1x20"};
  std::sort (names.begin(), names.end(), io::naturalLess);
  EXPECT_THAT (
      names, ::testing::ElementsAre ("a", "a1x3", "a1x20", "a2", "a02b", "a10", "b1"));
  EXPECT_EQ (io::lastName ("/x/y/"), "y");
  EXPECT_EQ (io::parentFolder ("/x/y/"), "/x");
  EXPECT_EQ (io::nameBelow ("/x/", "/x/y/z"), "y/z");
  EXPECT_EQ (io::nameBelow ("/x/y", "/x/y/"), "y");
}

TEST (Cases, ReadTheGeneratorsTruth)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeSequence (made, folder ("bodies"));
  const auto sequence =
      openDataset (io::DatasetKind::Automatic, folder ("bodies/")).front();
  EXPECT_EQ (sequence->name(), "bodies");
  ASSERT_EQ (sequence->frames(), 3);
  expectSame (sequence->frame (2).depth, made.frames[2].depth, 0.0, 5000, true);
  EXPECT_THROW (sequence->frame (3), InvalidInput);
  EXPECT_THROW (sequence->truth (0, -1), InvalidInput);
  EXPECT_EQ (sequence->frame (2).camera.fx, made.camera.fx);
  const io::MotionTruth truth = sequence->truth (0, 2);
  expectSame (truth.flow, made.truth[2].flow, 0.0, 5000);
  expectSame (truth.scene_flow, made.truth[2].scene_flow, 0.0, 5000);
  EXPECT_EQ (agreement (truth.visible, made.truth[2].visible), 1.0);
  EXPECT_EQ (cv::countNonZero (truth.labels != made.labels), 0);
  EXPECT_FALSE (truth.rigid);
  ASSERT_EQ (truth.bodies.size(), made.bodies.size());
  ASSERT_GT (made.bodies.size(), 1u);
  for (std::size_t label = 0; label < made.bodies.size(); ++label)
    EXPECT_THAT (*truth.bodies[label],
                 test::isNear (made.bodies[label].framek_from_frame0[2], 1e-6, 1e-6));
  EXPECT_THAT (*sequence->cameraPose (2),
               test::isNear (made.frame0_from_framek[2], 1e-5, 1e-5));
}

TEST (Cases, ConcatenateMotionsBetweenOtherFrames)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeSequence (made, folder ("bodies"));
  const auto sequence = openDataset (io::DatasetKind::Cases, folder ("bodies")).front();
  const io::MotionTruth truth = sequence->truth (1, 2);
  EXPECT_TRUE (truth.flow.empty());
  const auto& poses = made.bodies[1].framek_from_frame0;
  const Eigen::Vector3d point (0.1, -0.2, 2.0);
  EXPECT_LT ((*truth.bodies[1] * (poses[1] * point) - poses[2] * point).norm(), 1e-6);
}

TEST (Cases, KnowNoLabelAndOneRigidScene)
{
  const TemporaryFolder folder;
  cv::Mat labels (24, 32, CV_8UC1, cv::Scalar (0));
  labels.at<unsigned char> (3, 4) = 255;
  putImage (folder ("gt/labels_0.png"), labels);
  putText (folder ("gt/pose_1.txt"), "1 0 0 0.5 0 1 0 0 0 0 1 0 0 0 0 1\n");
  putText (folder ("camera.txt"), "30 30 15.5 11.5 32 24 1000\n");
  for (const char* k : {"0", "1"})
    putImage (folder (std::string ("depth_") + k + ".png"),
              cv::Mat (24, 32, CV_16UC1, 2000.0));
  io::DatasetOptions options;
  options.depth_scale = 500.0;
  const auto sequence =
      openDataset (io::DatasetKind::Cases, folder (""), options).front();
  EXPECT_FLOAT_EQ (sequence->frame (0).depth.at<float> (1, 1), 4.0F);
  const io::MotionTruth truth = sequence->truth (0, 1);
  EXPECT_EQ (truth.labels.at<int> (3, 4), -1);
  EXPECT_EQ (truth.labels.at<int> (4, 3), 0);
  ASSERT_TRUE (truth.rigid);
  EXPECT_EQ (truth.rigid->translation().x(), 0.5);
  EXPECT_EQ (sequence->truth (1, 0).rigid->translation().x(), -0.5);
  EXPECT_EQ (sequence->cameraPose (1)->translation().x(), -0.5);
  EXPECT_EQ (sequence->cameraPose (0)->angle(), 0.0);
  putText (folder ("gt/object_poses_1.txt"), "0 1 1 0 0 0 0 1 0 0 0 0 1\n");
  expectIoError ([&] { sequence->truth (0, 1); },
                 "object_poses_1.txt: line 1",
                 "matrix element 3,4");
}

TEST (TruthParts, SeeWhatIsNotBehindAnything)
{
  cv::Mat flow (4, 8, CV_32FC2, cv::Scalar (1.0, 0.0));
  cv::Mat later (4, 8, CV_32FC1, cv::Scalar (2.0));
  cv::Mat second (4, 8, CV_32FC1, cv::Scalar (2.0));
  second.col (5).setTo (1.0);
  second.col (6).setTo (1.0);
  later.at<float> (0, 0) = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat seen = io::seenInBoth (flow, later, second);
  const std::vector<int> expected{255, 255, 255, 255, 0, 0, 255, 0};
  for (int col = 0; col < 8; ++col)
    EXPECT_EQ (seen.at<unsigned char> (2, col), expected[col]) << col;
  EXPECT_EQ (seen.at<unsigned char> (0, 0), 0);
  EXPECT_EQ (cv::countNonZero (io::staysInside (flow).col (7)), 0);
  EXPECT_EQ (cv::countNonZero (io::staysInside (flow).col (6)), 4);
}

} // namespace
