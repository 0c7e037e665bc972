// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/images.h>
#include <pcl_msf/visualization/animation_files.h>

#include <cstdlib>
#include <filesystem>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using namespace pcl_msf::visualization;

/** Three pictures, and a PATH that holds only what a test puts there. */
class AnimationFiles : public ::testing::Test {
protected:
  AnimationFiles() : path_ (std::getenv ("PATH"))
  {
    for (int i = 0; i < 3; ++i) {
      pictures_.push_back (folder_ ("p" + std::to_string (i) + ".png"));
      io::writeImage (pictures_.back(),
                      cv::Mat (33, 65, CV_8UC3, cv::Scalar::all (80 * i)));
    }
    std::filesystem::create_directory (folder_ ("bin"));
    setenv ("PATH", folder_ ("bin").c_str(), 1);
  }
  ~AnimationFiles() override { setenv ("PATH", path_.c_str(), 1); }

  /** A program that does what the lines of shell say. */
  void
  install (const std::string& name, const std::string& lines) const
  {
    namespace fs = std::filesystem;
    writeFile (folder_ ("bin/" + name), "#!/bin/sh\n" + lines);
    fs::permissions (folder_ ("bin/" + name), fs::perms::owner_all);
  }

  /** Nothing but the pictures, programs and the wanted file may be there. */
  void
  expectClean () const
  {
    for (const auto& entry : std::filesystem::directory_iterator (folder_ ("")))
      EXPECT_NE (entry.path().filename().string().front(), '.') << entry.path();
  }

  TemporaryFolder folder_;
  std::vector<std::string> pictures_;

private:
  std::string path_;
};

TEST_F (AnimationFiles, SaysWhatIsMissing)
{
  expectIoError ([this] { writeGif (folder_ ("a.gif"), pictures_, 10.0); },
                 "a.gif",
                 "install FFmpeg (Debian: ffmpeg)");
  expectIoError (
      [this] { writeGif (folder_ ("a.gif"), {}, 10.0); }, "a.gif", "picture");
  EXPECT_FALSE (std::filesystem::exists (folder_ ("a.gif")));
  expectClean();
}

TEST_F (AnimationFiles, TakesFfmpegAndHandsItThePictures)
{
  install ("ffmpeg",
           "for last; do :; done\n"
           "echo \"$*\" > \"$last\"\n"
           "while [ \"$1\" != -i ]; do shift; done\n"
           "while read -r line; do echo \"$line\"; done < \"$2\" >> \"$last\"\n");
  writeGif (folder_ ("a.gif"), pictures_, 10.0);
  const std::string list = readFile (folder_ ("a.gif"));
  for (const std::string& picture : pictures_)
    EXPECT_THAT (list, ::testing::HasSubstr ("file '" + picture + "'"));
  EXPECT_THAT (list, ::testing::HasSubstr ("-r 10.0")) << "the input's rate";
  expectClean();
}

TEST_F (AnimationFiles, TakesImageMagickWhenFfmpegFails)
{
  install ("ffmpeg", "exit 1\n");
  install ("convert", "for last; do :; done\necho \"$*\" > \"${last#gif:}\"\n");
  writeGif (folder_ ("a.gif"), pictures_, 25.0);
  const std::string arguments = readFile (folder_ ("a.gif"));
  EXPECT_THAT (arguments, ::testing::HasSubstr ("-delay 4"));
  EXPECT_THAT (arguments, ::testing::HasSubstr (pictures_[2]));
  expectClean();
}

TEST_F (AnimationFiles, FailingEncodersLeaveNothing)
{
  install ("ffmpeg", "for last; do :; done\necho half > \"$last\"\nexit 1\n");
  expectIoError (
      [this] { writeGif (folder_ ("a.gif"), pictures_, 10.0); }, "a.gif", "no program");
  EXPECT_FALSE (std::filesystem::exists (folder_ ("a.gif")));
  expectClean();
}

TEST_F (AnimationFiles, CancelEndsTheEncoder)
{
  install ("ffmpeg", "while :; do :; done\n");
  int asked = 0;
  expectIoError (
      [&] {
        writeGif (folder_ ("a.gif"), pictures_, 10.0, [&] { return ++asked > 3; });
      },
      "ffmpeg",
      "stopped");
  expectClean();
}

TEST_F (AnimationFiles, OpenCvWritesMp4WithoutPrograms)
{
  writeMp4 (folder_ ("a.mp4"), pictures_, 10.0);
  EXPECT_THAT (readFile (folder_ ("a.mp4")).substr (4, 4), "ftyp");
  expectClean();
}

} // namespace
