// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/images.h>
#include <pcl_msf/visualization/animation_files.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using namespace pcl_msf::visualization;

class AnimationFiles : public ::testing::Test {
protected:
  AnimationFiles()
  {
    for (int i = 0; i < 3; ++i) {
      pictures_.push_back (folder_ ("p" + std::to_string (i) + ".png"));
      io::writeImage (pictures_.back(),
                      cv::Mat (33, 65, CV_8UC3, cv::Scalar::all (80 * i)));
    }
  }

  TemporaryFolder folder_;
  std::vector<std::string> pictures_;
};

TEST_F (AnimationFiles, AreMp4WithEveryPicture)
{
  writeMp4 (folder_ ("a.mp4"), pictures_, 10.0);
  EXPECT_THAT (readFile (folder_ ("a.mp4")).substr (4, 4), "ftyp");
  cv::VideoCapture film (folder_ ("a.mp4"));
  cv::Mat picture;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE (film.read (picture)) << i;
    EXPECT_EQ (picture.size(), cv::Size (64, 32));
    EXPECT_NEAR (picture.at<cv::Vec3b> (16, 32)[0], 80 * i, 4) << i;
  }
  EXPECT_FALSE (film.read (picture));
  EXPECT_EQ (filesIn (folder_ ("")), 4U);
}

TEST_F (AnimationFiles, NothingIsLeftOfWhatFails)
{
  expectIoError (
      [this] { writeMp4 (folder_ ("a.mp4"), {}, 10.0); }, "a.mp4", "picture");
  expectIoError (
      [this] { writeMp4 (folder_ ("a.gif"), pictures_, 10.0); }, "a.gif", ".mp4");
  int asked = 0;
  expectIoError (
      [&] {
        writeMp4 (folder_ ("a.mp4"), pictures_, 10.0, [&] { return ++asked > 2; });
      },
      "a.mp4",
      "stopped");
  pictures_.push_back (folder_ ("none.png"));
  expectIoError (
      [this] { writeMp4 (folder_ ("a.mp4"), pictures_, 10.0); }, "none.png", "");
  EXPECT_EQ (filesIn (folder_ ("")), 3U);
}

} // namespace
