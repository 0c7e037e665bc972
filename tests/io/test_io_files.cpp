// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/output_file.h"
#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/float_files.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

const float kNan = std::numeric_limits<float>::quiet_NaN();

template <typename T>
std::string
bytesOf (T value)
{
  std::string bytes (sizeof (T), '\0');
  std::memcpy (bytes.data(), &value, sizeof (T));
  return bytes;
}

/** The head of a .flo or .dpt file, its magic number spelled as bytes. */
std::string
taggedHead (std::int32_t width, std::int32_t height)
{
  return "PIEH" + bytesOf (width) + bytesOf (height);
}

TEST (FlowFile, HasThePublishedBytes)
{
  const TemporaryFolder folder;
  const cv::Mat flow =
      (cv::Mat_<cv::Vec2f> (1, 2) << cv::Vec2f (1.5F, -2.0F), cv::Vec2f (kNan, 0.0F));
  io::writeFlow (folder ("a.flo"), flow);
  EXPECT_EQ (readFile (folder ("a.flo")),
             taggedHead (2, 1) + bytesOf (1.5F) + bytesOf (-2.0F) + bytesOf (1e10F) +
                 bytesOf (1e10F));
}

TEST (FlowFile, ReadsHandMadeBytesAndMarksUnknown)
{
  const TemporaryFolder folder;
  writeFile (folder ("a.flo"),
             taggedHead (1, 2) + bytesOf (3.0F) + bytesOf (4.0F) + bytesOf (1.0F) +
                 bytesOf (2e9F));
  const cv::Mat flow = io::readFlow (folder ("a.flo"));
  ASSERT_EQ (flow.size(), cv::Size (1, 2));
  EXPECT_EQ (flow.at<cv::Vec2f> (0, 0), cv::Vec2f (3.0F, 4.0F));
  EXPECT_TRUE (std::isnan (flow.at<cv::Vec2f> (1, 0)[0]));
  EXPECT_TRUE (std::isnan (flow.at<cv::Vec2f> (1, 0)[1]));
}

TEST (FlowFile, RefusesMalformedFiles)
{
  const TemporaryFolder folder;
  const auto read = [&] (const std::string& bytes) {
    return [&folder, bytes] {
      writeFile (folder ("bad.flo"), bytes);
      io::readFlow (folder ("bad.flo"));
    };
  };
  expectIoError (read (""), "bad.flo", "magic number");
  expectIoError (read ("JUNKJUNKJUNK"), "bad.flo", "magic number");
  expectIoError (read ("PIEH"), "bad.flo", "width");
  expectIoError (read (taggedHead (0, 5)), "bad.flo", "width");
  expectIoError (read (taggedHead (-3, 5)), "bad.flo", "width");
  expectIoError (read (taggedHead (1000000000, 1000000000)), "bad.flo", "width");
  expectIoError (read (taggedHead (4, 4) + "short"), "bad.flo", "pixels");
  expectIoError (
      [&] { io::readFlow (folder ("none.flo")); }, "none.flo", "no such file");
  expectIoError ([&] { io::readFlow (folder ("")); }, folder (""), "not a file");
}

TEST (FlowFile, LeavesNothingBehindWhenItCannotBeWritten)
{
  const TemporaryFolder folder;
  const cv::Mat flow (2, 2, CV_32FC2, cv::Scalar::all (1));
  expectIoError ([&] { io::writeFlow (folder ("no/such/a.flo"), flow); },
                 "a.flo",
                 "cannot be written");
  std::filesystem::create_directory (folder ("taken.flo"));
  expectIoError ([&] { io::writeFlow (folder ("taken.flo"), flow); },
                 "taken.flo",
                 "cannot be written");
  expectIoError ([&] { io::writeFlow (folder ("a.flo"), cv::Mat()); }, "a.flo", "flow");
  EXPECT_EQ (pcl_msf::testing::filesIn (folder ("")), 1U);
}

/** A writer that is killed in the middle. \return its process' state */
int
killedWriter (const std::string& path)
{
  const pid_t writer = fork();
  if (writer == 0)
    io::writeThenRename (path, [] (const std::string& temporary) {
      writeFile (temporary, "half");
      raise (SIGKILL);
    });
  int status = 0;
  waitpid (writer, &status, 0);
  return status;
}

TEST (OutputFile, WhatAKilledWriterLeftGoesWithTheNextOne)
{
  const TemporaryFolder folder;
  writeFile (folder (".a.flo.part"), "mine");
  writeFile (folder (".a.flo.99999999.0.part"), "mine");
  writeFile (folder (".pcl_msf.part"), "mine");
  std::filesystem::create_symlink (folder (".a.flo.part"),
                                   folder (".pcl_msf.99999999.0.part"));
  ASSERT_TRUE (WIFSIGNALED (killedWriter (folder ("a.flo"))));
  ASSERT_EQ (filesIn (folder ("")), 5U);
  io::writeBytes (folder ("b.txt"), "another", 7);
  EXPECT_EQ (filesIn (folder ("")), 5U) << "the user's, and the new one";
  EXPECT_EQ (readFile (folder ("b.txt")), "another");
}

TEST (OutputFile, WhatALivingWriterHasBegunStays)
{
  const TemporaryFolder folder;
  io::writeThenRename (folder ("a.txt"), [&] (const std::string& temporary) {
    writeFile (temporary, "first"); // by the name, as OpenCV and PCL do
    const pid_t other = fork();
    if (other == 0) {
      io::writeBytes (folder ("b.txt"), "other", 5);
      _exit (0);
    }
    waitpid (other, nullptr, 0);
    io::writeBytes (folder ("a.txt"), "second", 6);
    EXPECT_EQ (readFile (temporary), "first");
  });
  EXPECT_EQ (readFile (folder ("a.txt")), "first");
  EXPECT_EQ (readFile (folder ("b.txt")), "other");
  EXPECT_EQ (filesIn (folder ("")), 2U);
}

TEST (OutputFile, ReplacesFilesAloneAndTakesAnyName)
{
  const TemporaryFolder folder;
  const auto write = [&] (const std::string& name) {
    return [&folder, name] { io::writeBytes (folder (name), "new", 3); };
  };
  ASSERT_EQ (mkfifo (folder ("pipe").c_str(), 0600), 0);
  expectIoError (write ("pipe"), "pipe", "no regular file");
  writeFile (folder ("real"), "old");
  std::filesystem::create_symlink ("real", folder ("link"));
  std::filesystem::create_symlink ("later", folder ("dangling"));
  write ("link")();
  write ("dangling")();
  EXPECT_TRUE (std::filesystem::is_symlink (folder ("link")));
  EXPECT_EQ (readFile (folder ("real")), "new");
  EXPECT_EQ (readFile (folder ("later")), "new");
  for (const std::string& name : {std::string (255, 'n'),
                                  std::string ("%s a\n.b"),
                                  "a." + std::string (250, 'e')})
    EXPECT_NO_THROW (write (name)()) << name;
}

TEST (DptFile, HasThePublishedBytesAndRoundTrips)
{
  const TemporaryFolder folder;
  const cv::Mat depth = (cv::Mat_<float> (2, 1) << 1.25F, 1e8F);
  io::writeDpt (folder ("a.dpt"), depth);
  EXPECT_EQ (readFile (folder ("a.dpt")),
             taggedHead (1, 2) + bytesOf (1.25F) + bytesOf (1e8F));
  EXPECT_EQ (cv::countNonZero (io::readDpt (folder ("a.dpt")) != depth), 0);
}

TEST (PfmFile, RowsRunFromTheBottomInEitherByteOrder)
{
  const TemporaryFolder folder;
  writeFile (folder ("little.pfm"),
             "Pf\n1 2\n-1.0\n" + bytesOf (7.0F) + bytesOf (8.0F));
  writeFile (folder ("big.pfm"),
             std::string ("Pf 1 2 1\n") + std::string ("\x40\xE0\0\0\x41\0\0\0", 8));
  for (const char* name : {"little.pfm", "big.pfm"}) {
    const cv::Mat image = io::readPfm (folder (name));
    ASSERT_EQ (image.type(), CV_32FC1);
    EXPECT_EQ (image.at<float> (0, 0), 8.0F) << name;
    EXPECT_EQ (image.at<float> (1, 0), 7.0F) << name;
  }
}

TEST (PfmFile, ColourRoundTripKeepsTheChannelOrder)
{
  const TemporaryFolder folder;
  const cv::Mat image =
      (cv::Mat_<cv::Vec3f> (1, 2) << cv::Vec3f (1, 2, 3), cv::Vec3f (4, 5, 6));
  io::writePfm (folder ("a.pfm"), image);
  EXPECT_EQ (readFile (folder ("a.pfm")).substr (0, 17),
             "PF\n2 1\n-1\n" + bytesOf (1.0F) + bytesOf (2.0F).substr (0, 3));
  const cv::Mat back = io::readPfm (folder ("a.pfm"));
  EXPECT_EQ (cv::norm (back, image, cv::NORM_INF), 0.0);
}

TEST (PfmFile, RefusesMalformedFiles)
{
  const TemporaryFolder folder;
  const auto read = [&] (const std::string& bytes) {
    return [&folder, bytes] {
      writeFile (folder ("bad.pfm"), bytes);
      io::readPfm (folder ("bad.pfm"));
    };
  };
  expectIoError (read (""), "bad.pfm", "type");
  expectIoError (read ("P6\n1 1\n255\n"), "bad.pfm", "type");
  expectIoError (read ("Pf\nwide 1\n-1\n"), "bad.pfm", "width");
  expectIoError (read ("Pf\n1"), "bad.pfm", "width");
  expectIoError (read ("Pf\n1 1\n0\n0000"), "bad.pfm", "scale");
  expectIoError (read ("Pf\n999999999 999999999\n-1\n"), "bad.pfm", "width");
  expectIoError (read ("Pf\n99999999999 1\n-1\n"), "bad.pfm", "width");
  expectIoError (read ("Pf\n8 8\n-1\nshort"), "bad.pfm", "pixels");
}

} // namespace
