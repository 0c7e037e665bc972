// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/timed_lists.h"
#include "support/compare_images.h"
#include "support/expect_io_error.h"
#include "support/format_bytes.h"
#include "support/pose_matcher.h"
#include "support/small_sequence.h"
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/io/pose_files.h>
#include <pcl_msf/synthetic/sequence_writer.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;
using io::openDataset;

void
writeTum (const std::string& folder)
{
  SequenceWriterOptions options;
  options.layout = SequenceLayout::Tum;
  writeSequence (smallSequence(), folder, options);
}

TEST (Tum, ReadsWhatTheGeneratorWrites)
{
  const TemporaryFolder folder;
  const SyntheticSequence& made = smallSequence();
  writeTum (folder ("room"));
  const auto sequence =
      openDataset (io::DatasetKind::Automatic, folder (""), withCamera()).front();
  EXPECT_EQ (sequence->name(), "room");
  ASSERT_EQ (sequence->frames(), 3);
  EXPECT_NEAR (sequence->timestamp (2), 1.0 + 2.0 / 30.0, 1e-6);
  const io::RgbdImages images = sequence->frame (1);
  EXPECT_EQ (cv::norm (images.color, made.frames[1].color, cv::NORM_INF), 0.0);
  expectSame (images.depth, made.frames[1].depth, 0.000101, 5000, true);
  ASSERT_TRUE (sequence->cameraPose (1));
  EXPECT_THAT (*sequence->cameraPose (1),
               test::isNear (made.frame0_from_framek[1], 1e-6, 1e-6));
  EXPECT_TRUE (sequence->truth (0, 1).flow.empty());
}

TEST (Tum, KnowsTheCameraByTheName)
{
  const TemporaryFolder folder;
  const auto focal = [&folder] (const std::string& name) {
    const std::string top = folder (name);
    putText (top + "/rgb.txt", "1.0 rgb/1.0.png\n");
    putText (top + "/depth.txt", "1.0 depth/1.0.png\n");
    putImage (top + "/rgb/1.0.png", cv::Mat (480, 640, CV_8UC3, 1.0));
    putImage (top + "/depth/1.0.png", cv::Mat (480, 640, CV_16UC1, 5000.0));
    return openDataset (io::DatasetKind::Tum, top).front()->frame (0).camera.fx;
  };
  EXPECT_EQ (focal ("rgbd_dataset_freiburg1_xyz"), 517.3);
  EXPECT_EQ (focal ("rgbd_dataset_freiburg2_desk"), 520.9);
  EXPECT_EQ (focal ("rgbd_dataset_freiburg3_walking_xyz"), 535.4);
  EXPECT_EQ (focal ("office"), 525.0);
  putText (folder ("office/camera.txt"), "600 601 320 240 640 480 2500\n");
  const auto images =
      openDataset (io::DatasetKind::Tum, folder ("office")).front()->frame (0);
  EXPECT_EQ (images.camera.fy, 601.0);
  EXPECT_FLOAT_EQ (images.depth.at<float> (3, 3), 2.0F);
  io::DatasetOptions options;
  options.depth_scale = 1000.0;
  EXPECT_FLOAT_EQ (openDataset (io::DatasetKind::Tum, folder ("office"), options)
                       .front()
                       ->frame (0)
                       .depth.at<float> (3, 3),
                   5.0F);
}

TEST (Tum, RefusesScaledImagesWithoutTheirCamera)
{
  const TemporaryFolder folder;
  const std::string top = folder ("rgbd_dataset_freiburg1_small");
  putText (top + "/rgb.txt", "1.0 rgb/1.0.png\n");
  putText (top + "/depth.txt", "1.0 depth/1.0.png\n");
  putImage (top + "/rgb/1.0.png", cv::Mat (240, 320, CV_8UC3, 1.0));
  putImage (top + "/depth/1.0.png", cv::Mat (240, 320, CV_16UC1, 5000.0));
  expectIoError ([&] { openDataset (io::DatasetKind::Tum, top).front()->frame (0); },
                 "depth/1.0.png",
                 "width, height");
  putText (top + "/camera.txt", "260 260 160 128 320 240 5000\n");
  EXPECT_EQ (openDataset (io::DatasetKind::Tum, top).front()->frame (0).camera.fx,
             260.0);
}

TEST (Tum, AssociatesTheClosestFirstAndEachOnce)
{
  const std::vector<io::TimedFile> color{{1.00, "a"}, {1.03, "b"}, {1.06, "c"}};
  const std::vector<io::TimedFile> depth{{1.015, "p"}, {1.028, "q"}, {1.085, "r"}};
  // b and q are 2 ms apart, a and p 15; r is 25 ms from c.
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{0, 0}, {1, 1}};
  EXPECT_EQ (io::associate (color, depth, 0.02), expected);
  EXPECT_EQ (io::associate (color, depth, 0.03).size(), 3u);
  // The only depth image goes to the closer one, which is not the first.
  const std::vector<io::TimedFile> single{{1.02, "p"}};
  const std::vector<std::pair<std::size_t, std::size_t>> closest{{1, 0}};
  EXPECT_EQ (io::associate (color, single, 0.03), closest);
  EXPECT_TRUE (io::associate (color, depth, 0.001).empty());
}

TEST (Tum, InterpolatesPoses)
{
  const auto turned = [] (double angle, double x) {
    return RigidPose{{0.0, angle, 0.0, x, 0.0, 0.0}};
  };
  const std::vector<io::TimedPose> poses{{1.0, turned (0.0, 0.0)},
                                         {1.01, turned (0.2, 1.0)}};
  const auto pose = io::poseAt (poses, 1.0025, 0.02);
  ASSERT_TRUE (pose);
  EXPECT_NEAR (pose->parameters[1], 0.05, 1e-6);
  EXPECT_NEAR (pose->parameters[3], 0.25, 1e-9);
  EXPECT_NEAR (io::poseAt (poses, 1.01, 0.02)->parameters[3], 1.0, 1e-12);
  EXPECT_FALSE (io::poseAt (poses, 0.999, 0.02));
  EXPECT_FALSE (io::poseAt (poses, 1.02, 0.02));
  EXPECT_FALSE (io::poseAt (poses, 1.0025, 0.005));
}

TEST (Tum, ReadsTheTrajectoriesThatResultsHave)
{
  const TemporaryFolder folder;
  const std::vector<io::TimedPose> poses{{0.5, {}},
                                         {1.5, {{0.1, 0.2, 0.3, 1.0, 2.0, 3.0}}}};
  io::writeTrajectory (folder ("trajectory.txt"), poses);
  const std::vector<io::TimedPose> read =
      io::readTrajectory (folder ("trajectory.txt"));
  ASSERT_EQ (read.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ (read[k].seconds, poses[k].seconds);
    EXPECT_THAT (read[k].world_from_camera,
                 test::isNear (poses[k].world_from_camera, 1e-6, 1e-6));
  }
}

TEST (Tum, ReadsListsThatAnEditorSaved)
{
  const TemporaryFolder folder;
  writeTum (folder (""));
  for (const char* list : {"rgb.txt", "depth.txt", "groundtruth.txt"})
    putText (folder (list), "\xEF\xBB\xBF" + readFile (folder (list)));
  const auto open = [&] {
    return openDataset (io::DatasetKind::Tum, folder (""), withCamera())[0];
  };
  EXPECT_EQ (open()->frames(), 3);
  EXPECT_TRUE (open()->cameraPose (0));
  putText (folder ("rgb.txt"),
           "\xEF\xBB\xBF"
           "1.0 rgb/1.000000.png\n");
  EXPECT_EQ (open()->frames(), 1) << "the mark stood before the only line";
  putText (folder ("rgb.txt"),
           std::string ("\xFF\xFE"
                        "1\0.\0",
                        6));
  expectIoError (open, "rgb.txt", "UTF-16");
}

TEST (Tum, StampsInSmallerUnitsBecomeSeconds)
{
  EXPECT_EQ (io::secondsOf (1305031102.175304), 1305031102.175304);
  EXPECT_DOUBLE_EQ (io::secondsOf (1305031102175.0), 1305031102.175);
  EXPECT_DOUBLE_EQ (io::secondsOf (1305031102175304.0), 1305031102.175304);
  EXPECT_NEAR (io::secondsOf (1305031102175304000.0), 1305031102.175304, 1e-6);
  for (const double seconds : {0.0, 12.5, -3.0, 33333333.0, 1e6})
    EXPECT_EQ (io::secondsOf (seconds), seconds);
  const TemporaryFolder folder;
  putText (folder ("rgb.txt"), "1305031102175304000 rgb/a.png\n");
  putText (folder ("depth.txt"), "1305031102.160407 depth/a.png\n");
  putText (folder ("groundtruth.txt"),
           "1305031102175.3 1 2 3 0 0 0 1\n"
           "1305031102175.4 1 2 3 0 0 0 1\n");
  const auto sequence = openDataset (io::DatasetKind::Tum, folder ("")).front();
  ASSERT_EQ (sequence->frames(), 1);
  EXPECT_NEAR (sequence->timestamp (0), 1305031102.175304, 1e-6);
  ASSERT_TRUE (sequence->cameraPose (0));
  EXPECT_EQ (sequence->cameraPose (0)->parameters[4], 2.0);
}

TEST (Tum, TimesSinceTheStartGetTheUnitOfTheOtherList)
{
  const std::vector<io::TimedFile> seconds{{1.0, "a"}, {1.033, "b"}, {1.066, "c"}};
  for (const double unit : {1e3, 1e6, 1e9})
    for (const bool is_first : {true, false}) {
      std::vector<io::TimedFile> first = seconds, second = seconds;
      for (io::TimedFile& file : is_first ? first : second)
        file.time = (file.time + 0.004) * unit;
      io::matchUnits (first, second, 0.02);
      EXPECT_EQ (io::associate (first, second, 0.02).size(), 3u) << unit;
      EXPECT_NEAR (first[1].time, 1.035, 0.003);
    }
  // All of one list becomes nearly the same time: no unit, but other clocks.
  std::vector<io::TimedFile> first = seconds;
  std::vector<io::TimedFile> second{{1000000001.0, "p"}, {1000000011.0, "q"}};
  first.insert (first.begin(), {{0.1, "x"}, {0.2, "y"}});
  second.push_back ({1000000021.0, "r"});
  io::matchUnits (first, second, 0.02);
  EXPECT_EQ (second.front().time, 1000000001.0);
}

TEST (Tum, NamesWhatIsDamaged)
{
  const TemporaryFolder folder;
  writeTum (folder (""));
  const auto open = [&] {
    return openDataset (io::DatasetKind::Tum, folder (""), withCamera())[0];
  };
  std::filesystem::remove (folder ("rgb/1.033333.png"));
  expectIoError ([&] { open()->frame (1); }, "rgb/1.033333.png", "no such file");
  const std::string poses = readFile (folder ("groundtruth.txt"));
  putText (folder ("groundtruth.txt"), "1.0 0 0 0 0 0 0\n");
  expectIoError (open, "groundtruth.txt: line 1", "qw: missing");
  putText (folder ("groundtruth.txt"), "# t\n1.0 0 0 0 0 0 0 0.5\n");
  expectIoError (open, "groundtruth.txt: line 2", "quaternion");
  putText (folder ("groundtruth.txt"), poses);
  putText (folder ("depth.txt"), "# d\n1,0 depth/1.0.png\n");
  expectIoError (open, "depth.txt: line 2", "timestamp: '1,0'");
  putText (folder ("depth.txt"), "1.0\n");
  expectIoError (open, "depth.txt: line 1", "filename: missing");
  putText (folder ("depth.txt"), "7.0 depth/7.0.png\n");
  expectIoError (open,
                 "depth.txt",
                 "timestamp: the closest are 1.066667 in rgb.txt and 7.000000 in "
                 "depth.txt, 5.93333 s apart, and less than 0.02 s are paired");
  std::filesystem::remove (folder ("depth.txt"));
  expectIoError (open, "depth.txt", "no such file");
}

} // namespace
