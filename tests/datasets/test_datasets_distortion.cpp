// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/compare_images.h"
#include "support/expect_io_error.h"
#include "support/format_bytes.h"
#include "support/small_sequence.h"
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/io/undistortion.h>
#include <pcl_msf/synthetic/sequence_writer.h>

#include <algorithm>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;
using io::openDataset;

const LensDistortion kLens{0.2, -0.3, -0.004, 0.003, 0.1};
const LensDistortion kFreiburg1{0.2624, -0.9531, -0.0054, 0.0026, 1.1633};

/** Moving bodies through a lens, or through none. */
SyntheticSequence
through (const LensDistortion& lens)
{
  SequenceOptions options;
  options.scene = SceneKind::MultiBody;
  options.width = 160;
  options.height = 120;
  options.effects.distortion = lens;
  return synthesize (options);
}

const SyntheticSequence&
bent ()
{
  static const SyntheticSequence sequence = through (kLens);
  return sequence;
}

const SyntheticSequence&
straight ()
{
  static const SyntheticSequence sequence = through ({});
  return sequence;
}

io::RgbdImages
imagesOf (const SyntheticSequence& sequence)
{
  return {sequence.frames[0].color, sequence.frames[0].depth, sequence.camera};
}

TEST (Distortion, IsTakenOutOfColourAndDepth)
{
  io::RgbdImages images = imagesOf (bent());
  io::undistort (images, kLens);
  EXPECT_EQ (images.distortion, kLens);
  EXPECT_EQ (images.camera.fx, straight().camera.fx);
  const SyntheticFrame& exact = straight().frames[0];
  const auto colorError = [&exact] (const cv::Mat& color) {
    return cv::norm (color, exact.color, cv::NORM_L1) / exact.color.total();
  };
  EXPECT_LT (colorError (images.color), 0.5 * colorError (bent().frames[0].color));
  int known = 0, same = 0, near = 0;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) {
      const float z = images.depth.at<float> (v, u);
      if (!(z > 0.0F))
        continue;
      ++known;
      const float error = std::abs (z - exact.depth.at<float> (v, u)) / z;
      same += error < 2e-4F;
      near += error < 0.02F;
    }
  EXPECT_GT (known, 0.85 * 160 * 120);
  EXPECT_GT (same, 0.5 * known); // not on slanted surfaces: 1 % from pixel to pixel
  EXPECT_GT (near, 0.9 * known); // not at borders
}

TEST (Distortion, DepthNeverHangsBetweenSurfaces)
{
  io::RgbdImages images;
  images.camera = {130.0, 130.0, 79.5, 59.5};
  images.depth = cv::Mat (120, 160, CV_32FC1, 2.0F);
  images.depth.colRange (60, 100).setTo (1.0F);
  images.depth.colRange (100, 102).setTo (std::nanf (""));
  io::undistort (images, kLens);
  int near = 0, far = 0, none = 0;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) {
      const float z = images.depth.at<float> (v, u);
      near += std::abs (z - 1.0F) < 1e-6F;
      far += std::abs (z - 2.0F) < 1e-6F;
      none += std::isnan (z);
    }
  EXPECT_EQ (near + far + none, 120 * 160);
  EXPECT_GT (near, 3000);
  EXPECT_GT (none, 200);
}

TEST (Distortion, IsTakenOutOnceAndOnlyWhereItCanBe)
{
  io::RgbdImages images = imagesOf (bent());
  const cv::Mat before = images.depth;
  io::undistort (images, {});
  EXPECT_EQ (images.depth.data, before.data);
  EXPECT_THROW (io::undistort (images, {-9.0, 0.0, 0.0, 0.0, 0.0}), InvalidInput);
  io::undistort (images, kLens);
  EXPECT_THROW (io::undistort (images, kLens), InvalidInput);
}

TEST (Distortion, CameraFileMaySayIt)
{
  const TemporaryFolder folder;
  const std::string file = folder ("camera.txt");
  io::CameraFile camera{{130.0, 131.0, 80.0, 60.0}, 160, 120, 1000.0, kLens};
  io::writeCamera (file, camera);
  EXPECT_EQ (io::readCamera (file).distortion, kLens);
  putText (file, "130 131 80 60 160 120 1000 0.2 -0.3 -0.004 0.003");
  EXPECT_EQ (io::readCamera (file).distortion.p2, 0.003);
  EXPECT_EQ (io::readCamera (file).distortion.k3, 0.0);
  putText (file, "130 131 80 60 160 120 1000");
  EXPECT_TRUE (io::readCamera (file).distortion.isNone());
  putText (file, "130 131 80 60 160 120 1000 0.2 -0.3");
  expectIoError ([&] { io::readCamera (file); }, "camera.txt", "k1 k2 p1 p2");
  putText (file, "130 131 80 60 160 120 1000 -9 0 0 0");
  expectIoError ([&] { io::readCamera (file); }, "camera.txt", "k1 -9");
}

TEST (Distortion, OfAFolderIsItsOwnOrTheCallers)
{
  const TemporaryFolder folder;
  writeSequence (bent(), folder ("case"));
  const auto depth = [&folder] (const io::DatasetOptions& options) {
    return openDataset (io::DatasetKind::Cases, folder ("case"), options)
        .front()
        ->frame (0)
        .depth;
  };
  const cv::Mat plain = depth ({});
  io::DatasetOptions asked;
  asked.distortion = kLens;
  const cv::Mat freed = depth (asked);
  EXPECT_GT (cv::countNonZero (freed != plain), 5000);
  io::CameraFile camera = io::readCamera (folder ("case/camera.txt"));
  camera.distortion = kLens;
  io::writeCamera (folder ("case/camera.txt"), camera);
  expectSame (depth ({}), freed, 0.0, 0, true);
  expectSame (io::DataFolder (folder ("case")).frame (0).depth, freed, 0.0, 0, true);
  asked.distortion = LensDistortion();
  expectSame (depth (asked), plain, 0.0, 0, true);
  asked.distortion.reset();
  asked.camera = straight().camera; // a camera of the caller's has its own lens
  expectSame (depth (asked), plain, 0.0, 0, true);
}

TEST (Distortion, OfTumIsThePublishedOne)
{
  const TemporaryFolder folder;
  const auto read = [&folder] (const std::string& name) {
    const std::string top = folder (name);
    putText (top + "/rgb.txt", "1.0 rgb/1.0.png\n");
    putText (top + "/depth.txt", "1.0 depth/1.0.png\n");
    putImage (top + "/rgb/1.0.png", cv::Mat (480, 640, CV_8UC3, 1.0));
    putImage (top + "/depth/1.0.png", cv::Mat (480, 640, CV_16UC1, 5000.0));
    return openDataset (io::DatasetKind::Tum, top).front()->frame (0).distortion;
  };
  EXPECT_EQ (read ("rgbd_dataset_freiburg1_xyz"), kFreiburg1);
  EXPECT_EQ (read ("rgbd_dataset_freiburg2_desk").k3, 0.9172);
  EXPECT_TRUE (read ("rgbd_dataset_freiburg3_walking_xyz").isNone());
  EXPECT_TRUE (read ("office").isNone());
  putText (folder ("rgbd_dataset_freiburg1_own/camera.txt"),
           "517 517 320 240 640 480 5000");
  EXPECT_TRUE (read ("rgbd_dataset_freiburg1_own").isNone());
}

TEST (Distortion, IsRefusedWhereThereIsNone)
{
  const TemporaryFolder folder;
  io::DatasetOptions options;
  options.distortion = kLens;
  SequenceWriterOptions sintel;
  sintel.layout = SequenceLayout::Sintel;
  writeSequence (smallSequence(), folder ("sintel"), sintel);
  EXPECT_THROW (openDataset (io::DatasetKind::Sintel, folder ("sintel"), options),
                InvalidInput);
  EXPECT_THROW (openDataset (io::DatasetKind::Automatic, folder ("sintel"), options),
                InvalidInput);
}

TEST (Distortion, ReportNamesIt)
{
  SceneFlow flow;
  flow.camera = {517.25, 516.5, 318.5, 255.25};
  const std::string freed = io::reportJson (flow, {}, 2, kLens);
  EXPECT_NE (freed.find ("\"fx\": 517.25"), std::string::npos);
  EXPECT_NE (freed.find ("\"k2\": -0.3"), std::string::npos);
  EXPECT_EQ (io::reportJson (flow, {}).find ("removed_distortion"), std::string::npos);
}

} // namespace
