// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Reading and writing in an application that has taken the user's locale.
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include "support/small_sequence.h"
#include "support/temporary_folder.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/html_report.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/pose_files.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/io/text_files.h>
#include <pcl_msf/synthetic/sequence_writer.h>

#include <clocale>
#include <cstdlib>
#include <map>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;

/** 1.234.567,8 in streams. */
class CommaPunctuation : public std::numpunct<char> {
  char
  do_decimal_point () const override
  {
    return ',';
  }
  char
  do_thousands_sep () const override
  {
    return '.';
  }
  std::string
  do_grouping () const override
  {
    return "\3";
  }
};

/** By the C library's functions: an installed locale or one made here. */
bool
setLocale (const std::string& name, const TemporaryFolder& folder)
{
  if (std::setlocale (LC_ALL, (name + ".UTF-8").c_str()) != nullptr)
    return true;
  const std::string command = "localedef -i " + name + " -f UTF-8 " +
                              folder (name + ".UTF-8") + " >/dev/null 2>&1";
  if (std::system (command.c_str()) != 0)
    return false;
  setenv ("LOCPATH", folder ("").c_str(), 1);
  return std::setlocale (LC_ALL, (name + ".UTF-8").c_str()) != nullptr;
}

SceneFlow
smallResult ()
{
  SceneFlow flow;
  const SyntheticSequence& made = smallSequence();
  flow.camera = made.camera;
  flow.labels = made.labels.clone();
  flow.displacement = made.truth[1].scene_flow.clone();
  flow.flow = made.truth[1].flow.clone();
  flow.visibility = cv::Mat (flow.labels.size(), CV_8UC1, cv::Scalar (255));
  flow.points.create (flow.labels.size(), CV_32FC3);
  for (int v = 0; v < flow.points.rows; ++v)
    for (int u = 0; u < flow.points.cols; ++u) {
      const Eigen::Vector3d p =
          flow.camera.backProject (u, v, made.frames[0].depth.at<float> (v, u));
      flow.points.at<cv::Vec3f> (v, u) = cv::Vec3f (p.x(), p.y(), p.z());
    }
  flow.dominant_motion = {{0.1, -0.25, 0.5, 1234.5, -0.125, 1e-9}};
  flow.report.message = "done";
  return flow;
}

void
writeAll (const TemporaryFolder& folder)
{
  const SceneFlow flow = smallResult();
  MultiframeSceneFlow window;
  window.frames = {SceneFlow{}, flow};
  window.motions = {{0, 1, {flow.dominant_motion}}};
  io::writeCamera (folder ("camera.txt"), {flow.camera, 3200, 2400, 1234.5});
  io::writePose (folder ("pose.txt"), flow.dominant_motion);
  io::writePoses (folder ("poses.yaml"), window, {1000, 2000});
  io::writePoses (folder ("poses.json"), window, {1000, 2000});
  io::writeTrajectory (folder ("trajectory.txt"),
                       {{1305031102.175304, flow.dominant_motion}});
  io::writeReport (folder ("report.json"), flow, {1.5, 0.25}, 2000);
  io::writeSceneFlowCloud (folder ("scene_flow.pcd"), flow, {});
  SequenceWriterOptions options;
  for (const SequenceLayout layout : {SequenceLayout::Cases, SequenceLayout::Tum}) {
    options.layout = layout;
    options.depth_scale = 1234.5;
    writeSequence (smallSequence(),
                   folder (layout == SequenceLayout::Tum ? "tum" : "cases"),
                   options);
  }
  std::string why;
  PinholeCamera{1234567.5, 0.25, 0, 0}.isValid (1024, 2048, &why);
  io::writeText (folder ("camera_error.txt"), why);
  SequenceOptions absurd;
  absurd.motion_pixels = 1234.5;
  absurd.isValid (&why);
  io::writeText (folder ("sequence_error.txt"), why);
}

/** Bytes of each file by its name. */
std::map<std::string, std::string>
contents (const TemporaryFolder& folder)
{
  namespace fs = std::filesystem;
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator (folder ("")))
    if (entry.is_regular_file())
      files[fs::relative (entry.path(), folder ("")).string()] =
          readFile (entry.path().string());
  return files;
}

/** What the files say, as text in a fixed form. */
std::string
readAll (const TemporaryFolder& folder)
{
  std::string text;
  const auto add = [&text] (double value) {
    text += std::to_string (std::llround (1e6 * value)) + " ";
  };
  const io::CameraFile camera = io::readCamera (folder ("camera.txt"));
  add (camera.depth_scale);
  add (camera.camera.cx);
  add (io::readPose (folder ("pose.txt")).parameters[1]);
  for (const auto& [name, value] : io::entryOfFolder (folder ("")).numbers)
    text += name + "=" + value + " ";
  add (io::readSceneFlowCloud (folder ("scene_flow.pcd"))
           .scene_flow.points.at<cv::Vec3f> (40, 40)[2]);
  for (const auto& [name, kind] : {std::pair{"tum", io::DatasetKind::Tum},
                                   std::pair{"cases", io::DatasetKind::Cases}}) {
    const auto sequence = io::openDataset (kind, folder (name), withCamera()).front();
    add (sequence->timestamp (1));
    add (sequence->frame (1).depth.at<float> (40, 40));
    add (sequence->cameraPose (1)->parameters[4]);
  }
  pcl::PointCloud<pcl::PointXYZI> cloud (16, 12);
  for (auto& point : cloud) {
    point.x = point.y = 0.125F;
    point.z = 3.378645F;
    point.intensity = 0.5F;
  }
  pcl::io::savePCDFileASCII (folder ("ascii.pcd"), cloud);
  const auto back = io::readOrganizedCloud (folder ("ascii.pcd"));
  add ((*back)[100].z);
  add ((*back)[100].r);
  io::writeDpt (folder ("a.DPT"), cv::Mat (2, 2, CV_32FC1, cv::Scalar (0.5)));
  io::writeImage (folder ("a.TIFF"), cv::Mat (2, 2, CV_8UC1, cv::Scalar (9)));
  add (io::readDepth (folder ("a.DPT"), 1000.0).at<float> (0, 0));
  add (io::readColor (folder ("a.TIFF")).at<unsigned char> (0, 0));
  return text;
}

class Locale : public ::testing::Test {
protected:
  void
  SetUp () override
  {
    writeAll (plain_);
    expected_ = contents (plain_);
    read_ = readAll (plain_);
  }
  void
  TearDown () override
  {
    std::locale::global (std::locale::classic()); // C's, too
  }
  void
  expectTheSame () const
  {
    const TemporaryFolder folder;
    writeAll (folder);
    EXPECT_EQ (contents (folder), expected_);
    EXPECT_EQ (readAll (folder), read_);
  }

private:
  TemporaryFolder plain_;
  std::map<std::string, std::string> expected_;
  std::string read_;
};

TEST_F (Locale, OfStreamsChangesNothing)
{
  std::locale::global (std::locale (std::locale::classic(), new CommaPunctuation));
  std::ostringstream probe;
  probe << 1234.5;
  ASSERT_EQ (probe.str(), "1.234,5");
  expectTheSame();
}

TEST_F (Locale, OfTheCLibraryChangesNothing)
{
  for (const char* name : {"de_DE", "tr_TR"}) { // the second has its own small I
    const TemporaryFolder folder;
    if (!setLocale (name, folder))
      GTEST_SKIP() << "no locale " << name << " and no localedef to make it";
    ASSERT_STREQ (std::localeconv()->decimal_point, ",");
    expectTheSame();
    EXPECT_STREQ (std::localeconv()->decimal_point, ",") << "left as it was";
    std::setlocale (LC_ALL, "C");
    unsetenv ("LOCPATH");
  }
}

} // namespace
