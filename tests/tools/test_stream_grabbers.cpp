// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/lzf_image_io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tools/stream_tool.h"
#include <gmock/gmock.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// PCL's grabbers of files as sources of pcl_msf_stream, and cameras that are not there.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

class StreamGrabbers : public StreamTool {
protected:
  static constexpr int kFrames = 5;

  /** As `clouds/room_8.pcd` and so on, by number, not by letters. */
  void
  writeClouds () const
  {
    io::makeFolder (folder_ ("clouds"));
    const std::vector<test::View> views = test::renderWindow (scene_, kFrames);
    for (int k = 0; k < kFrames; ++k)
      pcl::io::savePCDFileBinary (cloudFile (k), cloudOf (views[k]));
  }
  std::string
  cloudFile (int frame) const
  {
    return folder_ ("clouds/room_" + std::to_string (8 + frame) + ".pcd");
  }
  /** As PCL's ImageGrabber wants them. \param depth_extension of formats whose rows it
   * reads from the last one up or from the first one down */
  void
  writeImages (const std::string& depth_extension) const
  {
    io::makeFolder (folder_ ("images"));
    const std::vector<test::View> views = test::renderWindow (scene_, kFrames);
    for (int k = 0; k < kFrames; ++k) {
      cv::Mat color, depth;
      views[k].color.convertTo (color, CV_8U, 255.0);
      cv::cvtColor (color, color, cv::COLOR_GRAY2BGR);
      views[k].depth.convertTo (depth, CV_16U, kDepthScale);
      const std::string number = std::to_string (8 + k);
      io::writeImage (folder_ ("images/rgb_" + number + ".png"), color);
      io::writeImage (folder_ ("images/depth_" + number + depth_extension), depth);
    }
    io::writeCamera (folder_ ("images/camera.txt"), camera());
  }
  /** As PCL's recorders do: each frame with its camera and, by its name, its time. */
  void
  writeCompressed () const
  {
    io::makeFolder (folder_ ("compressed"));
    pcl::io::CameraParameters lens;
    lens.focal_length_x = scene_.camera.fx;
    lens.focal_length_y = scene_.camera.fy;
    lens.principal_point_x = scene_.camera.cx;
    lens.principal_point_y = scene_.camera.cy;
    pcl::io::LZFDepth16ImageWriter depth_writer; // of millimetres
    pcl::io::LZFRGB24ImageWriter color_writer;
    const std::vector<test::View> views = test::renderWindow (scene_, kFrames);
    for (int k = 0; k < kFrames; ++k) {
      cv::Mat color, depth;
      views[k].color.convertTo (color, CV_8U, 255.0);
      cv::cvtColor (color, color, cv::COLOR_GRAY2RGB);
      views[k].depth.convertTo (depth, CV_16U, 1000.0);
      const std::string name = folder_ ("compressed/frame_20260102T030405." +
                                        std::to_string (100000 * (k + 1)));
      const auto width = static_cast<std::uint32_t> (scene_.width);
      const auto height = static_cast<std::uint32_t> (scene_.height);
      ASSERT_TRUE (color_writer.write (reinterpret_cast<const char*> (color.data),
                                       width,
                                       height,
                                       name + "_rgb.pclzf"));
      ASSERT_TRUE (depth_writer.write (reinterpret_cast<const char*> (depth.data),
                                       width,
                                       height,
                                       name + "_depth.pclzf"));
      ASSERT_TRUE (depth_writer.writeParameters (lens, name + ".xml"));
      ASSERT_TRUE (color_writer.writeParameters (lens, name + ".xml"));
    }
  }
  ToolRun
  grab (const std::string& source, const std::string& options) const
  {
    return run (folder_ (source) + " --as-fast-as-possible --output " +
                folder_ ("out") + " --grabber " + options);
  }

private:
  pcl::PointCloud<pcl::PointXYZRGBA>
  cloudOf (const test::View& view) const
  {
    pcl::PointCloud<pcl::PointXYZRGBA> cloud (scene_.width, scene_.height);
    for (int v = 0; v < scene_.height; ++v)
      for (int u = 0; u < scene_.width; ++u) {
        auto& point = cloud (u, v);
        point.getVector3fMap() =
            scene_.camera.backProject (u, v, view.depth.at<float> (v, u)).cast<float>();
        point.r = point.g = point.b =
            cv::saturate_cast<std::uint8_t> (255.0F * view.color.at<float> (v, u));
      }
    return cloud;
  }
};

TEST_F (StreamGrabbers, PcdFilesFollowTheCamera)
{
  writeClouds();
  ASSERT_EQ (grab ("clouds", "pcd").status, 0);
  expectFollowed (trajectory(), kFrames);
  EXPECT_EQ (report()["dropped"], 0);
  const std::string of_folder = readFile (folder_ ("out/trajectory.txt"));
  std::string list = "# of a recorder\n\n";
  for (int k = 0; k < kFrames; ++k)
    list += "clouds/room_" + std::to_string (8 + k) + ".pcd\r\n";
  writeFile (folder_ ("list.txt"), list);
  ASSERT_EQ (grab ("list.txt", "pcd").status, 0);
  EXPECT_EQ (readFile (folder_ ("out/trajectory.txt")), of_folder);
  io::CameraFile other = camera();
  other.camera.fx *= 2.0;
  io::writeCamera (folder_ ("clouds/camera.txt"), other);
  EXPECT_THAT (grab ("clouds", "pcd").err, HasSubstr ("not the camera's"));
}

TEST_F (StreamGrabbers, ImagesFollowTheCameraUprightInEveryFormat)
{
  for (const char* depth : {".png", ".tiff"}) {
    writeImages (depth);
    ToolRun done = grab ("images", "image");
    ASSERT_EQ (done.status, 0) << done.err;
    expectFollowed (trajectory(), kFrames);
    const std::string by_file = readFile (folder_ ("out/trajectory.txt"));
    std::filesystem::remove (folder_ ("images/camera.txt"));
    done = grab ("images", "image");
    EXPECT_EQ (done.status, 1);
    EXPECT_THAT (done.err, HasSubstr ("--camera"));
    const auto& c = scene_.camera;
    done = grab ("images",
                 "image --depth-scale 5000 --camera " + std::to_string (c.fx) + "," +
                     std::to_string (c.fy) + "," + std::to_string (c.cx) + "," +
                     std::to_string (c.cy));
    ASSERT_EQ (done.status, 0) << done.err;
    EXPECT_EQ (readFile (folder_ ("out/trajectory.txt")), by_file);
    io::CameraFile distorted = camera();
    distorted.distortion.k1 = 0.1;
    io::writeCamera (folder_ ("images/camera.txt"), distorted);
    EXPECT_THAT (grab ("images", "image").err, HasSubstr ("distorted"));
    std::filesystem::remove_all (folder_ ("images"));
  }
}

TEST_F (StreamGrabbers, CompressedImagesBringTheirCameraAndTimes)
{
  writeCompressed();
  const ToolRun done = grab ("compressed", "image");
  ASSERT_EQ (done.status, 0) << done.err;
  const std::vector<Line> lines = trajectory();
  expectFollowed (lines, kFrames);
  EXPECT_NEAR (lines.back().seconds - lines.front().seconds, 0.4, 1e-5);
  std::filesystem::remove (folder_ ("compressed/frame_20260102T030405.300000.xml"));
  EXPECT_THAT (grab ("compressed", "image").err, HasSubstr ("4 .xml files for 5"));
}

TEST_F (StreamGrabbers, SayWhichFilesAreLostAndGoOn)
{
  writeClouds();
  writeFile (cloudFile (2), "damaged");
  ToolRun done = grab ("clouds", "pcd");
  EXPECT_EQ (done.status, 3);
  EXPECT_EQ (done.errorLines(), 1) << done.err;
  EXPECT_THAT (done.err, HasSubstr ("frame 2: lost"));
  EXPECT_THAT (done.err, HasSubstr ("room_10.pcd"));
  EXPECT_EQ (trajectory().size(), kFrames - 1U);
  EXPECT_LT (distance (4, trajectory().back().pose), 0.02);
  writeImages (".png");
  const cv::Mat bytes = cv::Mat::ones (scene_.height, scene_.width, CV_8U);
  io::writeImage (folder_ ("images/depth_10.png"), bytes); // PCL reads beyond its end
  io::writeImage (folder_ ("images/rgb_11.png"), bytes);   // likewise
  done = grab ("images", "image");
  EXPECT_EQ (done.status, 3);
  EXPECT_EQ (done.errorLines(), 2) << done.err;
  EXPECT_THAT (done.err, HasSubstr ("depth_10.png: PCL's ImageGrabber"));
  EXPECT_THAT (done.err, HasSubstr ("rgb_11.png: PCL's ImageGrabber"));
}

TEST_F (StreamGrabbers, RefuseInOneLine)
{
  writeClouds();
  const auto refused = [&] (const std::string& arguments, const std::string& words) {
    const ToolRun done = run (arguments + " --output " + folder_ ("out"));
    EXPECT_EQ (done.status, 1) << arguments;
    if (arguments.find ("openni2") == std::string::npos) { // else drivers print, too
      EXPECT_EQ (done.errorLines(), 1) << done.err;
    }
    EXPECT_THAT (done.err, HasSubstr (words));
  };
  const std::string clouds = folder_ ("clouds");
  for (const char* grabber : {"pcd", "image"}) {
    refused (folder_ ("nowhere") + " --grabber " + grabber, "nowhere");
    refused ("--grabber " + std::string (grabber), "SOURCE");
  }
  for (const char* grabber : {"openni2", "realsense2"}) {
    const std::string camera = "no-such-camera --grabber " + std::string (grabber);
    refused (camera, "'no-such-camera'");
    refused (camera + " --rate 5", "--rate");
    refused (camera + " --as-fast-as-possible", "--as-fast-as-possible");
  }
  refused (clouds + " --grabber kinect", "openni2");
  refused (clouds + " --grabber image", "two are needed");
  refused (clouds + " --grabber pcd --distortion 1,0,0,0", "--distortion");
  refused (cloudFile (0) + " --grabber pcd", "two are needed");
  refused (clouds + " --grabber pcd --camera 900,900,1,1", "room_8.pcd");
  const ToolRun inside = run (clouds + " --grabber pcd --output " + clouds);
  EXPECT_THAT (inside.err, HasSubstr ("give another folder"));
  EXPECT_FALSE (std::filesystem::exists (folder_ ("out/trajectory.txt")));
}

TEST_F (StreamGrabbers, EndBySignalAndLeaveWhatWasComputed)
{
  writeClouds();
  const std::vector<std::string> arguments{
      folder_ ("clouds"), "--grabber", "pcd", "--rate", "0.001"};
  EXPECT_EQ (signalAfter ("frame 0: ", SIGINT, arguments), 128 + SIGINT);
  EXPECT_EQ (report()["interrupted"], true);
  EXPECT_EQ (trajectory().size(), 1U);
}

} // namespace
