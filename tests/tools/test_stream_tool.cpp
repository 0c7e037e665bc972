// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/player/frame_maker.h"
#include "stream/statistics.h"
#include "tools/stream_tool.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/float_files.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

// pcl_msf_stream, run as a user runs it.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

TEST_F (StreamTool, FollowsTheCamera)
{
  writeRecording (5);
  const ToolRun done = run (
      folder_ ("room") + " --as-fast-as-possible --flow --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  const std::vector<Line> lines = trajectory();
  expectFollowed (lines, 5);
  for (int k = 0; k < 5; ++k)
    EXPECT_EQ (lines[k].seconds, k);
  EXPECT_EQ (io::readFlow (folder_ ("out/flow_0_4.flo")).cols, scene_.width);
  const auto counts = report();
  EXPECT_EQ (counts["frames"], 5);
  EXPECT_EQ (counts["tracked"], 5);
  EXPECT_EQ (counts["dropped"], 0);
  EXPECT_EQ (counts["interrupted"], false);
  EXPECT_GT (counts["latency_ms"]["median"], 0.0);
  EXPECT_GE (counts["latency_ms"]["percentile_99"], counts["latency_ms"]["median"]);
  for (const char* words : {"frame 4: ", " Hz, latency ", "motion groups", "5 tracked"})
    EXPECT_THAT (done.out, HasSubstr (words));
}

TEST_F (StreamTool, CountsWhatItDrops)
{
  constexpr int frames = 40;
  writeRecording (frames, 2);
  const ToolRun done = run (folder_ ("room") +
                            " --rate 2000 --rigid --quiet --output " + folder_ ("out"));
  ASSERT_EQ (done.out + done.err, "");
  const auto counts = report();
  EXPECT_EQ (counts["frames"], frames);
  EXPECT_GT (counts["dropped"], 0);
  const std::vector<Line> lines = trajectory();
  EXPECT_EQ (counts["tracked"], lines.size());
  EXPECT_EQ (counts["tracked"].get<int>() + counts["dropped"].get<int>(), frames);
  ASSERT_GE (lines.size(), 1U); // a busy machine may start to solve late
  EXPECT_EQ (lines.back().seconds, frames - 1) << "the newest is not dropped";
}

TEST_F (StreamTool, PlaysListsByTheirTimes)
{
  writeTumRecording ({100.0, 100.2, 100.4});
  for (const char* source : {"tum", "tum/rgb.txt"}) {
    const auto begin = std::chrono::steady_clock::now();
    const ToolRun done =
        run (folder_ (source) + " --quiet --output " + folder_ ("out"));
    ASSERT_EQ (done.status, 0) << done.err;
    EXPECT_GE (std::chrono::steady_clock::now() - begin,
               std::chrono::milliseconds (400));
    const std::vector<Line> lines = trajectory();
    ASSERT_GE (lines.size(), 1U);
    EXPECT_NEAR (lines.back().seconds, 100.4, 1e-6);
  }
}

TEST_F (StreamTool, SaysWhichFramesAreLostAndGoesOn)
{
  writeRecording (5);
  cover (2);
  writeFile (folder_ ("room/depth_3.png"), "damaged");
  const ToolRun done =
      run (folder_ ("room") + " --as-fast-as-possible --output " + folder_ ("out"));
  EXPECT_EQ (done.status, 3);
  EXPECT_EQ (done.errorLines(), 2) << done.err;
  EXPECT_THAT (done.err, HasSubstr ("frame 2: lost"));
  EXPECT_THAT (done.err, HasSubstr ("frame 3: lost"));
  EXPECT_THAT (done.err, HasSubstr ("depth_3.png"));
  EXPECT_EQ (report()["lost"], 2);
  const std::vector<Line> lines = trajectory();
  ASSERT_EQ (lines.size(), 3U);
  EXPECT_EQ (lines.back().seconds, 4);
  EXPECT_LT (distance (4, lines.back().pose), 0.02);
}

class StreamToolSignals : public StreamTool,
                          public ::testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P (All, StreamToolSignals, ::testing::Values (SIGINT, SIGTERM));

TEST_P (StreamToolSignals, LeaveWhatWasComputed)
{
  writeTumRecording ({100.0, 100.05, 100.1, 4000.0});
  EXPECT_EQ (signalAfter ("frame 2: ", GetParam(), {folder_ ("tum")}),
             128 + GetParam());
  const std::vector<Line> lines = trajectory();
  ASSERT_GE (lines.size(), 1U);
  EXPECT_NEAR (lines.back().seconds, 100.1, 1e-6);
  EXPECT_EQ (report()["interrupted"], true);
  EXPECT_EQ (report()["frames"], 3);
  EXPECT_EQ (report()["tracked"], lines.size());
}

TEST_F (StreamTool, EndsWhenNobodyGetsWhatComes)
{
  writeTumRecording ({100.0, 100.05, 100.1, 4000.0});
  runTool (folder_,
           "{ sleep 0.2; timeout --preserve-status 300 " + kTool + " " +
               folder_ ("tum") + "; echo $? >" + folder_ ("status") + "; } | true");
  EXPECT_EQ (readFile (folder_ ("status")), "0\n");
}

TEST_F (StreamTool, RefusesInOneLine)
{
  writeRecording (2);
  const auto refused = [&] (const std::string& arguments, const std::string& words) {
    const ToolRun done = run (arguments + " --output " + folder_ ("out"));
    EXPECT_EQ (done.status, 1) << arguments;
    EXPECT_EQ (done.errorLines(), 1) << done.err;
    EXPECT_THAT (done.err, HasSubstr (words));
  };
  const std::string room = folder_ ("room");
  refused (folder_ ("nowhere"), "nowhere");
  refused ("", "SOURCE");
  refused (room + " --rate 0", "--rate");
  refused (room + " --rate 5 --as-fast-as-possible", "--rate");
  refused (room + " --queue 0", "--queue");
  refused (room + " --window 17", "--window");
  refused (room + " --min-depth 50", "--min-depth");
  cover (0);
  refused (room, "frame 0");
  std::filesystem::remove (folder_ ("room/color_1.png"));
  std::filesystem::remove (folder_ ("room/depth_1.png"));
  refused (room, "two are needed");
  EXPECT_FALSE (std::filesystem::exists (folder_ ("out/trajectory.txt")));
}

TEST_F (StreamTool, OutputIsNeverTheRecording)
{
  writeRecording (2);
  writeTumRecording ({100.0, 100.1});
  for (const char* source : {"room", "tum", "tum/rgb.txt"})
    for (const char* output : {"room", "tum", "tum/rgb"}) {
      const ToolRun done =
          run (folder_ (source) + " --quiet --output " + folder_ (output));
      const bool other = std::string (source).front() != std::string (output).front();
      EXPECT_EQ (done.status, other ? 0 : 1) << source << output << done.err;
      EXPECT_EQ (done.errorLines(), other ? 0 : 1) << done.err;
      EXPECT_THAT (done.err, HasSubstr (other ? "" : "give another folder"));
    }
}

TEST (StreamStatistics, PercentileIsTheNearestRank)
{
  const std::vector<double> values{4.0, 1.0, 3.0, 2.0};
  EXPECT_EQ (tool::percentile (values, 0.5), 2.0);
  EXPECT_EQ (tool::percentile (values, 0.99), 4.0);
  EXPECT_EQ (tool::percentile (values, 0.01), 1.0);
  EXPECT_EQ (tool::percentile ({}, 0.5), 0.0);
}

/** The finest level of a frame of some width that a stream makes. */
int
finestLevel (int columns, bool halve_large, int given = 0)
{
  tool::PlayerSettings settings;
  settings.halve_large = halve_large;
  settings.frame.finest_level = given;
  tool::FrameMaker maker (settings, "stream", true, [] (const std::string& line) {
    ADD_FAILURE() << line;
  });
  tool::StreamFrame frame;
  maker.make (frame, [columns] {
    io::RgbdImages images;
    images.depth = cv::Mat (48, columns, CV_32FC1, cv::Scalar (2));
    images.camera = {500.0, 500.0, 0.5 * columns, 24.0};
    return images;
  });
  return frame.frame.finestLevel();
}

TEST (FrameMaker, HalvesLargeFramesWhereNobodySaysHow)
{
  EXPECT_EQ (finestLevel (480, true), 1);
  EXPECT_EQ (finestLevel (479, true), 0);
  EXPECT_EQ (finestLevel (480, false), 0);
  EXPECT_EQ (finestLevel (320, false, 2), 2);
}

} // namespace
