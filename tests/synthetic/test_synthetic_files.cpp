// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_writer.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;

class SyntheticFiles : public ::testing::Test {
protected:
  void
  SetUp () override
  {
    SequenceOptions options;
    options.scene = SceneKind::Street; // has a sky, so unknown values, too
    options.width = 96;
    options.height = 72;
    options.successive_truth = true;
    sequence_ = synthesize (options);
  }

  std::string
  bytesOf (const std::string& name) const
  {
    const std::string path = folder_ + "/" + name;
    EXPECT_TRUE (std::filesystem::exists (path)) << path;
    return readFile (path);
  }

  std::vector<double>
  numbersOf (const std::string& name) const
  {
    std::istringstream text (bytesOf (name));
    std::vector<double> numbers;
    for (double number; text >> number;)
      numbers.push_back (number);
    return numbers;
  }

  TemporaryFolder temporary_;
  const std::string folder_ = temporary_ ("sequence");
  SyntheticSequence sequence_;
};

/** The value at a byte offset. */
template <typename T>
T
valueAt (const std::string& bytes, std::size_t offset)
{
  T value{};
  EXPECT_LE (offset + sizeof (T), bytes.size());
  std::memcpy (&value, bytes.data() + offset, sizeof (T));
  return value;
}

bool
samePixels (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() && a.type() == b.type() &&
         cv::norm (a, b, cv::NORM_INF) == 0.0;
}

TEST_F (SyntheticFiles, CaseHoldsImagesCameraAndPoses)
{
  writeSequence (sequence_, folder_);
  EXPECT_TRUE (samePixels (cv::imread (folder_ + "/color_1.png", cv::IMREAD_UNCHANGED),
                           sequence_.frames[1].color));
  const std::vector<double> camera = numbersOf ("camera.txt");
  ASSERT_EQ (camera.size(), 7u);
  EXPECT_EQ (camera[0], sequence_.camera.fx);
  EXPECT_EQ (camera[3], sequence_.camera.cy);
  EXPECT_EQ (camera[4], 96.0);
  EXPECT_EQ (camera[6], 1.0);
  const std::vector<double> pose = numbersOf ("gt/pose_1.txt");
  ASSERT_EQ (pose.size(), 16u);
  const Eigen::Matrix4f matrix = sequence_.bodies[0].framek_from_frame0[1].matrix();
  for (int i = 0; i < 16; ++i)
    EXPECT_NEAR (pose[i], matrix (i / 4, i % 4), 1e-6);
  const cv::Mat labels =
      cv::imread (folder_ + "/gt/labels_0.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ (labels.type(), CV_8UC1);
  for (int v = 0; v < 72; ++v)
    for (int u = 0; u < 96; ++u)
      EXPECT_EQ (labels.at<unsigned char> (v, u),
                 static_cast<unsigned char> (sequence_.labels.at<int> (v, u)));
}

TEST_F (SyntheticFiles, ObjectPosesNameEachBody)
{
  writeSequence (sequence_, folder_);
  std::istringstream text (bytesOf ("gt/object_poses_1.txt"));
  std::string line;
  std::getline (text, line);
  EXPECT_EQ (line.front(), '#');
  for (std::size_t label = 0; label < sequence_.bodies.size(); ++label) {
    ASSERT_TRUE (std::getline (text, line));
    std::istringstream fields (line);
    std::size_t number;
    int rigid;
    double values[12];
    std::string name;
    fields >> number >> rigid;
    for (double& value : values)
      fields >> value;
    fields >> name;
    EXPECT_TRUE (fields);
    EXPECT_EQ (number, label);
    EXPECT_EQ (name, sequence_.bodies[label].name);
    const Eigen::Matrix4f matrix =
        sequence_.bodies[label].framek_from_frame0[1].matrix();
    for (int i = 0; i < 12; ++i)
      EXPECT_NEAR (values[i], matrix (i / 4, i % 4), 1e-5);
  }
}

TEST_F (SyntheticFiles, FlowAndSceneFlowHaveTheirFormatsBytes)
{
  writeSequence (sequence_, folder_);
  const std::string flo = bytesOf ("gt/flow_0_1.flo");
  ASSERT_EQ (flo.size(), 12u + 96 * 72 * 8);
  EXPECT_EQ (flo.substr (0, 4), "PIEH");
  EXPECT_EQ (valueAt<int> (flo, 4), 96);
  EXPECT_EQ (valueAt<int> (flo, 8), 72);
  const std::string pfm = bytesOf ("gt/scene_flow_0_1.pfm");
  const std::string header = "PF\n96 72\n-1\n";
  ASSERT_EQ (pfm.size(), header.size() + 96 * 72 * 12);
  EXPECT_EQ (pfm.substr (0, header.size()), header);
  int unknown = 0;
  for (int v = 0; v < 72; ++v)
    for (int u = 0; u < 96; ++u) {
      const cv::Vec2f flow = sequence_.truth[1].flow.at<cv::Vec2f> (v, u);
      const float x = valueAt<float> (flo, 12 + 8 * (96 * v + u));
      if (std::isnan (flow[0])) {
        EXPECT_GT (x, 1e9f);
        ++unknown;
        continue;
      }
      EXPECT_EQ (x, flow[0]);
      const std::size_t place = header.size() + 12 * (96 * (71 - v) + u);
      EXPECT_EQ (valueAt<float> (pfm, place + 8),
                 sequence_.truth[1].scene_flow.at<cv::Vec3f> (v, u)[2]);
    }
  EXPECT_GT (unknown, 100);
  // OpenCV turns the channels round.
  const cv::Mat zyx =
      cv::imread (folder_ + "/gt/scene_flow_0_1.pfm", cv::IMREAD_UNCHANGED);
  EXPECT_EQ (zyx.at<cv::Vec3f> (60, 40)[0],
             sequence_.truth[1].scene_flow.at<cv::Vec3f> (60, 40)[2]);
}

TEST_F (SyntheticFiles, DepthIsExactAsFloatAndRoundedIn16Bit)
{
  writeSequence (sequence_, folder_);
  const std::string dpt = bytesOf ("depth_0.dpt");
  ASSERT_EQ (dpt.size(), 12u + 96 * 72 * 4);
  SequenceWriterOptions options;
  options.depth_format = DepthFormat::Png16;
  options.depth_scale = 500.0;
  writeSequence (sequence_, folder_, options);
  EXPECT_EQ (numbersOf ("camera.txt").at (6), 500.0);
  const cv::Mat png = cv::imread (folder_ + "/depth_0.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ (png.type(), CV_16UC1);
  for (int v = 0; v < 72; ++v)
    for (int u = 0; u < 96; ++u) {
      const float z = sequence_.frames[0].depth.at<float> (v, u);
      EXPECT_EQ (valueAt<float> (dpt, 12 + 4 * (96 * v + u)), std::isnan (z) ? 0 : z);
      if (std::isnan (z) || z > 131.0f)
        EXPECT_EQ (png.at<unsigned short> (v, u), 0);
      else
        EXPECT_NEAR (png.at<unsigned short> (v, u) / 500.0, z, 0.00101);
    }
}

TEST_F (SyntheticFiles, TumListsImagesAndTrajectory)
{
  SequenceWriterOptions options;
  options.layout = SequenceLayout::Tum;
  writeSequence (sequence_, folder_, options);
  EXPECT_NE (bytesOf ("rgb.txt").find ("\n1.033333 rgb/1.033333.png\n"),
             std::string::npos);
  EXPECT_NE (bytesOf ("depth.txt").find ("\n1.000000 depth/1.000000.png\n"),
             std::string::npos);
  EXPECT_TRUE (
      samePixels (cv::imread (folder_ + "/rgb/1.033333.png", cv::IMREAD_UNCHANGED),
                  sequence_.frames[1].color));
  const std::string poses = bytesOf ("groundtruth.txt");
  std::istringstream last (poses.substr (poses.find ("\n1.033333 ") + 1));
  double values[8];
  for (double& value : values)
    last >> value;
  const Eigen::Vector3d t = sequence_.frame0_from_framek[1].translation();
  EXPECT_NEAR (values[3], t.z(), 1e-5);
  EXPECT_NEAR (values[7] * values[7] + values[4] * values[4] + values[5] * values[5] +
                   values[6] * values[6],
               1.0,
               1e-5);
}

TEST_F (SyntheticFiles, SintelHasItsFolders)
{
  SequenceWriterOptions options;
  options.layout = SequenceLayout::Sintel;
  options.name = "street_1";
  writeSequence (sequence_, folder_, options);
  for (const char* file : {"clean/street_1/frame_0002.png",
                           "depth/street_1/frame_0002.dpt",
                           "flow/street_1/frame_0001.flo",
                           "invalid/street_1/frame_0001.png",
                           "occlusions/street_1/frame_0001.png"})
    EXPECT_GT (bytesOf (file).size(), 50u);
  EXPECT_FALSE (std::filesystem::exists (folder_ + "/flow/street_1/frame_0002.flo"));
  const std::string cam = bytesOf ("camdata_left/street_1/frame_0002.cam");
  ASSERT_EQ (cam.size(), 4u + 9 * 8 + 12 * 8);
  EXPECT_EQ (valueAt<float> (cam, 0), 202021.25f);
  EXPECT_EQ (valueAt<double> (cam, 4), sequence_.camera.fx);
  EXPECT_EQ (valueAt<double> (cam, 4 + 5 * 8), sequence_.camera.cy);
  const RigidPose pose = sequence_.frame0_from_framek[1].inverse();
  EXPECT_NEAR (valueAt<double> (cam, 4 + 72 + 11 * 8), pose.translation().z(), 1e-12);
}

TEST_F (SyntheticFiles, SaysWhatCannotBeWritten)
{
  writeFile (folder_, "a file where a folder should be");
  try {
    writeSequence (sequence_, folder_);
    FAIL() << "wrote into a file";
  }
  catch (const IoError& error) {
    EXPECT_NE (std::string (error.what()).find (folder_), std::string::npos);
  }
  EXPECT_THROW (writeSequence ({}, folder_), InvalidInput);
  SequenceWriterOptions options;
  options.depth_scale = 0.0;
  EXPECT_THROW (writeSequence (sequence_, folder_, options), InvalidInput);
}

TEST_F (SyntheticFiles, RefusesAScaleThatHoldsNoDepthBeforeItWrites)
{
  SequenceWriterOptions options;
  options.depth_format = DepthFormat::Png16;
  for (const double scale : {0.05, 50000.0}) { // depth is 3.5 to 69 m
    options.depth_scale = scale;
    EXPECT_THROW (writeSequence (sequence_, folder_, options), InvalidInput) << scale;
    EXPECT_FALSE (std::filesystem::exists (folder_));
  }
  options.depth_format = DepthFormat::Automatic; // floats
  EXPECT_NO_THROW (writeSequence (sequence_, folder_, options));
}

} // namespace
