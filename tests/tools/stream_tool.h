// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include "support/run_tool.h"
#include "support/standing_room.h"
#include <nlohmann/json.hpp>
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/text_files.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

// pcl_msf_stream, run as a user runs it, on a camera that moves through a room.

namespace pcl_msf::testing {

inline const std::string kTool = PCL_MSF_TOOLS "/pcl_msf_stream";
inline constexpr double kDepthScale = 5000.0;

/** A line of a trajectory: seconds and a pose. */
struct Line {
  double seconds;
  RigidPose pose;
};

class StreamTool : public ::testing::Test {
protected:
  const test::AnalyticScene scene_ = test::standingRoom();

  /** A camera that moves through a room; after so many `places` it is back. */
  void
  writeRecording (int frames, int places = 5) const
  {
    writeImages (frames, places, "room/color_", "room/depth_");
    io::writeCamera (folder_ ("room/camera.txt"), camera());
  }
  /** The same with TUM's lists. \param times of the frames, seconds */
  void
  writeTumRecording (const std::vector<double>& times) const
  {
    const int frames = static_cast<int> (times.size());
    io::makeFolder (folder_ ("tum/rgb"));
    io::makeFolder (folder_ ("tum/depth"));
    writeImages (frames, frames, "tum/rgb/", "tum/depth/");
    io::writeCamera (folder_ ("tum/camera.txt"), camera());
    std::ostringstream color, depth;
    for (int k = 0; k < frames; ++k) {
      color << times[k] << " rgb/" << k << ".png\n";
      depth << times[k] << " depth/" << k << ".png\n";
    }
    writeFile (folder_ ("tum/rgb.txt"), color.str());
    writeFile (folder_ ("tum/depth.txt"), depth.str());
  }
  void
  cover (int frame) const
  {
    io::writeDepth (folder_ ("room/depth_" + std::to_string (frame) + ".png"),
                    cv::Mat::zeros (scene_.height, scene_.width, CV_32FC1),
                    kDepthScale);
  }
  ToolRun
  run (const std::string& arguments) const
  {
    return runTool (folder_, kTool + " " + arguments);
  }
  std::vector<Line>
  trajectory () const
  {
    std::vector<Line> lines;
    std::istringstream text (readFile (folder_ ("out/trajectory.txt")));
    for (std::string line; std::getline (text, line);) {
      double t = 0, x = 0, y = 0, z = 0, a = 0, b = 0, c = 0, w = 0;
      std::istringstream numbers (line);
      if (numbers >> t >> x >> y >> z >> a >> b >> c >> w)
        lines.push_back ({t,
                          RigidPose::fromMatrix (
                              Eigen::Quaterniond (w, a, b, c).matrix(), {x, y, z})});
    }
    return lines;
  }
  nlohmann::json
  report () const
  {
    return nlohmann::json::parse (readFile (folder_ ("out/report.json")));
  }
  double
  distance (int frame, const RigidPose& pose) const
  {
    return test::distanceToTruth (scene_, frame, pose);
  }
  void
  expectFollowed (const std::vector<Line>& lines, int frames) const
  {
    ASSERT_EQ (lines.size(), static_cast<std::size_t> (frames));
    for (int k = 0; k < frames; ++k)
      EXPECT_LT (distance (k, lines[k].pose), 0.004 * (1 + k)) << k;
  }
  /** \brief Runs the tool and ends it once it has printed some words. \return its exit
   * status, -1 without one */
  int
  signalAfter (const std::string& words,
               int signal,
               std::vector<std::string> arguments) const
  {
    const std::string printed = folder_ ("printed");
    arguments.insert (arguments.begin(), kTool);
    arguments.insert (arguments.end(), {"--output", folder_ ("out")});
    std::vector<char*> words_of_tool;
    for (std::string& argument : arguments)
      words_of_tool.push_back (argument.data());
    words_of_tool.push_back (nullptr);
    writeFile (printed, "");
    const pid_t tool = fork();
    if (tool == 0) {
      if (std::freopen (printed.c_str(), "w", stdout) != nullptr)
        execv (kTool.c_str(), words_of_tool.data());
      _exit (127);
    }
    int status = 0;
    while (readFile (printed).find (words) == std::string::npos) {
      if (waitpid (tool, &status, WNOHANG) != 0)
        return -1; // it has ended before
      std::this_thread::sleep_for (std::chrono::milliseconds (10));
    }
    kill (tool, signal);
    waitpid (tool, &status, 0);
    return WIFEXITED (status) ? WEXITSTATUS (status) : -1;
  }

  io::CameraFile
  camera () const
  {
    return {scene_.camera, scene_.width, scene_.height, kDepthScale};
  }

  TemporaryFolder folder_;

private:
  void
  writeImages (int frames,
               int places,
               const std::string& color,
               const std::string& depth) const
  {
    io::makeFolder (std::filesystem::path (folder_ (color)).parent_path().string());
    const std::vector<test::View> views = test::renderWindow (scene_, places);
    for (int k = 0; k < frames; ++k) {
      const test::View& view = views[k % places];
      cv::Mat gray;
      view.color.convertTo (gray, CV_8U, 255.0);
      const std::string file = std::to_string (k) + ".png";
      io::writeImage (folder_ (color + file), gray);
      io::writeDepth (folder_ (depth + file), view.depth, kDepthScale);
    }
  }
};

} // namespace pcl_msf::testing
