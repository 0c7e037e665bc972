// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/expect_refusal.h"
#include "support/small_scene.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/text_files.h>

#include <map>
#include <set>
#include <sstream>

// pcl_msf_scene_flow with more than two frames, run as a user runs it.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

const std::string kTool = PCL_MSF_TOOLS "/pcl_msf_scene_flow";

class SceneFlowWindow : public ::testing::Test {
protected:
  void
  writeRecording (int frames) const
  {
    io::makeFolder (folder_ ("case"));
    for (int frame = 0; frame < frames; ++frame) {
      const std::string k = std::to_string (frame);
      io::writeImage (folder_ ("case/color_" + k + ".png"), SmallScene::color (frame));
      io::writeDepth (
          folder_ ("case/depth_" + k + ".png"), SmallScene::depth (frame), 5000.0);
    }
    io::writeCamera (folder_ ("case/camera.txt"),
                     {{150.0, 150.0, 79.5, 59.5}, 160, 120, 5000.0});
  }
  ToolRun
  run (const std::string& arguments) const
  {
    return runTool (folder_, kTool + arguments);
  }
  bool
  exists (const std::string& name) const
  {
    return std::filesystem::exists (folder_ ("out/" + name));
  }
  double
  boxFlow (const std::string& name) const
  {
    return io::readFlow (folder_ ("out/" + name)).at<cv::Vec2f> (65, 75)[0];
  }

  TemporaryFolder folder_;
};

TEST_F (SceneFlowWindow, WritesEveryFrameOfThree)
{
  writeRecording (3);
  std::string files;
  for (const char* k : {"0", "1", "2"})
    files += " --color " + folder_ ("case/color_") + k + ".png --depth " +
             folder_ ("case/depth_") + k + ".png";
  const ToolRun done =
      run (files + " --camera 150,150,79.5,59.5 --depth-scale 5000 --output " +
           folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_NEAR (boxFlow ("flow_0_1.flo"), SmallScene::kBoxShift, 0.3);
  EXPECT_NEAR (boxFlow ("flow_0_2.flo"), 2 * SmallScene::kBoxShift, 0.3);
  for (const char* name : {"flow_0_2.png",
                           "scene_flow_0_1.pcd",
                           "scene_flow_0_2.pcd",
                           "warped_0_1.pcd",
                           "warped_0_2.pcd",
                           "visible_0_2.png",
                           "overview_0.png",
                           "report.json",
                           "report_0.json",
                           "poses_0.yaml",
                           "trajectory.txt"})
    EXPECT_TRUE (exists (name)) << name;
  cv::FileStorage poses (folder_ ("out/poses_0.json"),
                         cv::FileStorage::READ | cv::FileStorage::FORMAT_JSON);
  ASSERT_TRUE (poses.isOpened());
  EXPECT_EQ (poses["frames"].size(), 3U);
  EXPECT_EQ (poses["pairs"].size(), 3U);
  EXPECT_EQ (poses["pairs"][0]["segments"][0].size(), 6U);
  cv::FileStorage yaml (folder_ ("out/poses_0.yaml"), cv::FileStorage::READ);
  ASSERT_TRUE (yaml.isOpened());
  EXPECT_EQ (static_cast<int> (yaml["pairs"][1]["to"]),
             static_cast<int> (poses["pairs"][1]["to"]));
}

TEST_F (SceneFlowWindow, RunsAFolderInWindowsThatShareAFrame)
{
  writeRecording (4);
  const ToolRun done =
      run (" " + folder_ ("case") + " --window 3 --rigid --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  for (const char* name : {"flow_0_1.flo",
                           "flow_0_2.flo",
                           "flow_2_3.flo",
                           "poses_0.json",
                           "report_0.json",
                           "report_2.json"})
    EXPECT_TRUE (exists (name)) << name;
  EXPECT_FALSE (exists ("poses_2.json")) << "two frames";
  std::istringstream lines (readFile (folder_ ("out/trajectory.txt")));
  int poses = 0;
  for (std::string line; std::getline (lines, line);)
    poses += !line.empty() && line[0] != '#';
  EXPECT_EQ (poses, 4);
}

TEST_F (SceneFlowWindow, OneCoveredFrameIsNoSuccess)
{
  writeRecording (4);
  const cv::Size size (SmallScene::kWidth, SmallScene::kHeight);
  io::writeImage (folder_ ("case/color_1.png"),
                  cv::Mat (size, CV_8UC3, cv::Scalar::all (20.0)));
  io::writeDepth (
      folder_ ("case/depth_1.png"), cv::Mat (size, CV_32FC1, cv::Scalar (0.3)), 5000.0);
  int runs = 0;
  for (const char* mode : {" --window 2", " --window 3", " --window 3 --track"}) {
    const ToolRun done = run (" " + folder_ ("case") + mode + " --output " +
                              folder_ ("out" + std::to_string (runs++)));
    EXPECT_EQ (done.status, 3) << mode;
    EXPECT_THAT (done.err, HasSubstr ("not converged (nothing_determined)")) << mode;
  }
}

TEST_F (SceneFlowWindow, TracksAFolderFromOneReference)
{
  writeRecording (5);
  const ToolRun done =
      run (" " + folder_ ("case") + " --window 3 --track --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  for (int k = 1; k < 5; ++k) {
    const std::string pair = "_0_" + std::to_string (k);
    EXPECT_NEAR (boxFlow ("flow" + pair + ".flo"), k * SmallScene::kBoxShift, 0.4);
    for (const char* name : {"scene_flow", "warped"})
      EXPECT_TRUE (exists (name + pair + ".pcd")) << name << pair;
  }
  for (const char* name :
       {"report.json", "report_0.json", "overview_0.png", "poses_0.yaml"})
    EXPECT_TRUE (exists (name)) << name;
  cv::FileStorage poses (folder_ ("out/poses_0.json"),
                         cv::FileStorage::READ | cv::FileStorage::FORMAT_JSON);
  ASSERT_EQ (poses["frames"].size(), 3U);
  EXPECT_EQ (static_cast<int> (poses["frames"][1]), 3) << "place in the recording";
  std::istringstream lines (readFile (folder_ ("out/trajectory.txt")));
  int count = 0;
  for (std::string line; std::getline (lines, line);)
    count += !line.empty() && line[0] != '#';
  EXPECT_EQ (count, 5);
}

TEST_F (SceneFlowWindow, KeepsWhatItTrackedWhenAFrameIsDamaged)
{
  writeRecording (4);
  io::writeDepth (
      folder_ ("case/depth_3.png"), cv::Mat::zeros (120, 160, CV_32FC1), 5000.0);
  const ToolRun done =
      run (" " + folder_ ("case") + " --track --quiet --output " + folder_ ("out"));
  EXPECT_GT (done.status, 0);
  EXPECT_EQ (done.errorLines(), 1) << done.err;
  EXPECT_THAT (done.err, HasSubstr ("frame 3"));
  EXPECT_TRUE (exists ("flow_0_2.flo"));
  EXPECT_TRUE (exists ("trajectory.txt"));
}

/** Names in a folder, without hidden ones, and what is in the files. */
std::map<std::string, std::string>
contentOf (const std::string& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator (folder))
    if (entry.path().filename().string().front() != '.' && entry.is_regular_file())
      files[entry.path().filename().string()] = readFile (entry.path().string());
  return files;
}

std::set<std::string>
namesIn (const std::string& folder)
{
  std::set<std::string> names;
  for (const auto& [name, content] : contentOf (folder))
    names.insert (name);
  return names;
}

TEST_F (SceneFlowWindow, OutputIsNeverTheRecording)
{
  writeRecording (2);
  const auto before = contentOf (folder_ ("case"));
  std::filesystem::create_directory_symlink (folder_ ("case"), folder_ ("link"));
  for (const char* output : {"case", "link", "case/../link/.", "case/"})
    for (const char* mode : {"", " --track"}) {
      expectRefusal (
          run (" " + folder_ ("case") + mode + " --output " + folder_ (output)),
          output,
          {folder_ (output), "give another folder"});
    }
  EXPECT_EQ (contentOf (folder_ ("case")), before);
}

TEST_F (SceneFlowWindow, OutputIsNeverAnInputFile)
{
  writeRecording (2);
  const std::string command =
      " " + folder_ ("case") + " --quiet --output " + folder_ ("out");
  ASSERT_EQ (run (command).status, 0);
  const auto before = contentOf (folder_ ("out"));
  std::filesystem::create_hard_link (folder_ ("out/labels_0.png"), folder_ ("h.png"));
  std::filesystem::create_symlink (folder_ ("out/labels_0.png"), folder_ ("s.png"));
  for (const char* labels : {"out/labels_0.png", "h.png", "s.png"}) {
    expectRefusal (run (command + " --labels " + folder_ (labels)),
                   labels,
                   {folder_ ("out/labels_0.png"), folder_ (labels)});
  }
  EXPECT_EQ (contentOf (folder_ ("out")), before);
}

TEST_F (SceneFlowWindow, ALaterRunReplacesAnEarlierOneAndNothingElse)
{
  writeRecording (4);
  const std::string command = " " + folder_ ("case") + " --quiet --output ";
  ASSERT_EQ (run (command + folder_ ("out")).status, 0);
  writeFile (folder_ ("out/notes.txt"), "mine");
  writeFile (folder_ ("out/flow_7_8.png"), "mine, whatever its name says");
  writeFile (folder_ ("out/overlay_0_3.png"), "changed by the user");
  for (const char* name : {"color", "depth"})
    for (const char* k : {"_2.png", "_3.png"})
      std::filesystem::remove (folder_ (std::string ("case/") + name + k));
  const ToolRun done = run (command + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  ASSERT_EQ (run (command + folder_ ("fresh")).status, 0);
  std::set<std::string> expected = namesIn (folder_ ("fresh"));
  expected.insert ({"notes.txt", "flow_7_8.png", "overlay_0_3.png"});
  EXPECT_EQ (namesIn (folder_ ("out")), expected);
  EXPECT_EQ (readFile (folder_ ("out/overlay_0_3.png")), "changed by the user");
  for (const std::string& name : expected)
    for (const char* word : {"depth", "color", "rgb", "image", "cloud"})
      EXPECT_EQ (name.find (word), std::string::npos) << name << ": a recording's";
}

TEST_F (SceneFlowWindow, RefusesToReplaceWhatIsNotItsOwn)
{
  writeRecording (2);
  std::filesystem::create_directory (folder_ ("out"));
  writeFile (folder_ ("out/overview_0.png"), "mine");
  expectRefusal (run (" " + folder_ ("case") + " --output " + folder_ ("out")),
                 "case",
                 {"out/overview_0.png"});
  EXPECT_EQ (filesIn (folder_ ("out")), 1U) << "nothing is written";
  EXPECT_EQ (readFile (folder_ ("out/overview_0.png")), "mine");
}

TEST_F (SceneFlowWindow, AFailedRunLeavesTheEarlierResults)
{
  writeRecording (4);
  const std::string command =
      " " + folder_ ("case") + " --track --quiet --output " + folder_ ("out");
  ASSERT_EQ (run (command).status, 0);
  const auto before = contentOf (folder_ ("out"));
  const std::string depth = readFile (folder_ ("case/depth_3.png"));
  io::writeDepth (
      folder_ ("case/depth_3.png"), cv::Mat::zeros (120, 160, CV_32FC1), 5000.0);
  EXPECT_GT (run (command).status, 0);
  EXPECT_EQ (contentOf (folder_ ("out")), before);
  EXPECT_TRUE (exists ("unfinished/flow_0_2.flo")) << "what was done is kept, too";
  writeFile (folder_ ("case/depth_3.png"), depth);
  ASSERT_EQ (run (command).status, 0);
  EXPECT_EQ (namesIn (folder_ ("out")).size(), before.size());
  EXPECT_FALSE (exists ("unfinished"));
}

TEST_F (SceneFlowWindow, KnowsAStaticBackground)
{
  writeRecording (3);
  const ToolRun done =
      run (" " + folder_ ("case") + " --static-background 1 --quiet --output " +
           folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_NEAR (boxFlow ("flow_0_2.flo"), 2 * SmallScene::kBoxShift, 0.3)
      << "its points contradict it";
}

TEST_F (SceneFlowWindow, ReferenceInTheMiddle)
{
  writeRecording (3);
  const ToolRun done = run (" " + folder_ ("case") +
                            " --reference 1 --quiet --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_NEAR (boxFlow ("flow_1_0.flo"), -SmallScene::kBoxShift, 0.3);
  EXPECT_NEAR (boxFlow ("flow_1_2.flo"), SmallScene::kBoxShift, 0.3);
  EXPECT_TRUE (exists ("labels_1.png"));
}

TEST_F (SceneFlowWindow, RefusesInOneLine)
{
  writeRecording (3);
  const auto refused = [&] (const std::string& arguments, const std::string& words) {
    expectRefusal (
        run (arguments + " --output " + folder_ ("out")), arguments, {words});
  };
  const std::string folder = " " + folder_ ("case");
  refused (folder + " --window 1", "--window");
  refused (folder + " --reference 3", "--reference");
  refused (folder + " --track --reference 1", "--track");
  refused (folder + " --track --window 17", "--window");
  refused (folder + folder, "one word too many");
  refused (folder + " --depth x", "not together");
  refused (" " + folder_ ("nowhere"), "nowhere");
  std::filesystem::remove (folder_ ("case/depth_1.png"));
  refused (folder, "case");
}

} // namespace
