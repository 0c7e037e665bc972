// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "run_tool.h"
#include "small_scene.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/io/text_files.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

const std::string kTool = PCL_MSF_RENDER;

/** A folder with two frames; the tool runs without a display. */
class RenderTool : public ::testing::Test {
protected:
  RenderTool()
  {
    fs::create_directory (folder_ ("case"));
    for (int k = 0; k < 2; ++k) {
      const std::string number = std::to_string (k);
      io::writeImage (folder_ ("case/color_" + number + ".png"), SmallScene::color (k));
      io::writeDepth (
          folder_ ("case/depth_" + number + ".png"), SmallScene::depth (k), 5000.0);
    }
    io::writeCamera (folder_ ("case/camera.txt"),
                     {scene_.camera, SmallScene::kWidth, SmallScene::kHeight, 5000.0});
  }
  ToolRun
  run (const std::string& arguments) const
  {
    return runTool (folder_, "env -u DISPLAY " + kTool + " " + arguments);
  }
  void
  expectRefusal (const std::string& arguments, const std::string& words) const
  {
    const ToolRun refused = run (arguments);
    EXPECT_EQ (refused.status, 1) << arguments;
    EXPECT_EQ (refused.errorLines(), 1) << refused.err;
    EXPECT_THAT (refused.err, HasSubstr (words));
  }
  cv::Mat
  picture (const std::string& name) const
  {
    return cv::imread (folder_ ("out/" + name), cv::IMREAD_COLOR);
  }

  /** A stored result of the case, as pcl_msf_scene_flow writes it. */
  void
  writeResult () const
  {
    SceneFlow flow;
    flow.camera = scene_.camera;
    const cv::Size size (SmallScene::kWidth, SmallScene::kHeight);
    const cv::Mat depth = SmallScene::depth (0);
    flow.points.create (size, CV_32FC3);
    flow.displacement = cv::Mat (size, CV_32FC3, cv::Scalar (0.02, 0, 0));
    flow.labels = cv::Mat (size, CV_32SC1, cv::Scalar (0));
    flow.visibility = cv::Mat (size, CV_8UC1, cv::Scalar (Visibility::Visible));
    for (int row = 0; row < size.height; ++row)
      for (int col = 0; col < size.width; ++col) {
        const Eigen::Vector3f p =
            scene_.camera.backProject (col, row, depth.at<float> (row, col))
                .cast<float>();
        flow.points.at<cv::Vec3f> (row, col) = {p.x(), p.y(), p.z()};
      }
    fs::create_directory (folder_ ("result"));
    io::writeSceneFlowCloud (
        folder_ ("result/scene_flow_0_1.pcd"), flow, SmallScene::color (0));
  }

  TemporaryFolder folder_;
  SmallScene scene_;
};

TEST_F (RenderTool, DrawsEveryKindOfFrames)
{
  const ToolRun done =
      run (folder_ ("case") + " --kind all --window 1 --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  for (const char* name : {"before",
                           "after",
                           "before_tints",
                           "after_tints",
                           "warped",
                           "segments",
                           "motions",
                           "arrows",
                           "trajectories",
                           "residual",
                           "depth_residual",
                           "occlusion"}) {
    const cv::Mat image = picture (std::string (name) + ".png");
    ASSERT_EQ (image.size(), cv::Size (SmallScene::kWidth, SmallScene::kHeight))
        << name;
    cv::Mat white;
    cv::inRange (image, cv::Scalar::all (255), cv::Scalar::all (255), white);
    EXPECT_LT (cv::countNonZero (white), 0.7 * image.total()) << name;
  }
  EXPECT_GT (picture ("sheet.png").cols, 4 * SmallScene::kWidth);
  EXPECT_THAT (done.out, HasSubstr ("sheet.png"));
}

/** The sensor's view of the warped reference is the current image: the box has moved.
 */
TEST_F (RenderTool, WarpedCloudLooksLikeTheCurrentImage)
{
  const ToolRun done = run (folder_ ("case") +
                            " --kind warped --axes 0 --title 0 "
                            "--point-size 1.5 --output " +
                            folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  const cv::Rect inside (70, 50, 20, 30); // of the box, before and after
  const cv::Mat image = picture ("warped.png") (inside);
  const double to_current =
      cv::norm (image, SmallScene::color (1) (inside), cv::NORM_L1);
  const double to_reference =
      cv::norm (image, SmallScene::color (0) (inside), cv::NORM_L1);
  EXPECT_LT (to_current, 0.4 * to_reference);
}

TEST_F (RenderTool, DrawsStoredResultsWithViewsAndSizes)
{
  writeResult();
  ToolRun done = run (folder_ ("result") +
                      " --kind warped --view orbit --azimuth -30 "
                      "--size 200x100 --background black --output " +
                      folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_EQ (picture ("warped.png").size(), cv::Size (200, 100));
  EXPECT_EQ (picture ("warped.png").at<cv::Vec3b> (2, 190), cv::Vec3b (0, 0, 0));
  done =
      run (folder_ ("result") + " --sequence " + folder_ ("case") +
           " --kind after_tints --view top --parallel 1 --output " + folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_FALSE (picture ("after_tints.png").empty());
  expectRefusal (folder_ ("result") + " --kind after --output " + folder_ ("out"),
                 "needs the current frame");
  expectRefusal (folder_ ("result") + " --kind motions --output " + folder_ ("out"),
                 "bodies_0.png");
}

TEST_F (RenderTool, RefusesWhatItCannotDo)
{
  expectRefusal (folder_ ("nothing"), "there is none of that name");
  expectRefusal (folder_ (""), "camera.txt");
  expectRefusal (folder_ ("case") + " --kind portrait", "--kind: 'portrait'");
  expectRefusal (folder_ ("case") + " --size 9000x100", "--size");
  expectRefusal (folder_ ("case") + " --frame 7", "there is no frame 7");
  expectRefusal (folder_ ("case") + " --view user", "--eye");
  expectRefusal (folder_ ("case") + " --gif", "--animation");
  expectRefusal (folder_ ("case") + " --colour 1", "no such option");
  expectRefusal (folder_ ("case") + " --output /proc/nowhere --kind warped",
                 "cannot be made");
  EXPECT_EQ (run ("--help").status, 0);
}

TEST_F (RenderTool, NamesThePackageThatIsMissing)
{
  writeResult();
  const ToolRun refused =
      runTool (folder_,
               "env -u DISPLAY PATH=/nonexistent " + kTool + " " + folder_ ("result") +
                   " --kind warped --output " + folder_ ("out"));
  EXPECT_EQ (refused.status, 1);
  EXPECT_EQ (refused.errorLines(), 1) << refused.err;
  EXPECT_THAT (refused.err, HasSubstr ("sudo apt-get install xvfb"));
}

TEST_F (RenderTool, AnimationsAreNumberedPictures)
{
  writeResult();
  const ToolRun done = run (folder_ ("result") +
                            " --animation warp --pictures 4 "
                            "--output " +
                            folder_ ("out"));
  ASSERT_EQ (done.status, 0) << done.err;
  const cv::Mat still = picture ("warp/warp_0000.png");
  const cv::Mat moved = picture ("warp/warp_0002.png");
  ASSERT_EQ (still.size(), moved.size());
  EXPECT_GT (cv::norm (still, moved, cv::NORM_L1), 0.0);
  EXPECT_FALSE (picture ("warp/warp_0003.png").empty());
  EXPECT_TRUE (picture ("warp/warp_0004.png").empty());
}

/** First word of a file of /proc that is about a process. */
std::string
processName (const fs::path& process)
{
  std::string name = readFile ((process / "comm").string());
  return name.substr (0, name.find ('\n'));
}

/** Process ids of a process's children. */
std::vector<std::string>
childrenOf (const std::string& parent)
{
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator ("/proc")) {
    const std::string status = readFile ((entry.path() / "status").string());
    if (status.find ("\nPPid:\t" + parent + "\n") != std::string::npos)
      found.push_back (entry.path().filename().string());
  }
  return found;
}

bool
waitFor (const std::function<bool()>& condition)
{
  for (int i = 0; i < 3000 && !condition(); ++i)
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
  return condition();
}

TEST_F (RenderTool, SigtermLeavesNoDisplayAndNoHalfPicture)
{
  writeResult();
  const pid_t tool = fork();
  if (tool == 0) {
    unsetenv ("DISPLAY");
    execl (kTool.c_str(),
           kTool.c_str(),
           folder_ ("result").c_str(),
           "--quiet",
           "--animation",
           "warp",
           "--pictures",
           "2000",
           "--size",
           "1280x960",
           "--output",
           folder_ ("out").c_str(),
           nullptr);
    _exit (127);
  }
  ASSERT_TRUE (
      waitFor ([this] { return fs::exists (folder_ ("out/warp/warp_0002.png")); }));
  std::string display;
  for (const std::string& child : childrenOf (std::to_string (tool)))
    if (processName ("/proc/" + child) == "Xvfb")
      display = child;
  ASSERT_FALSE (display.empty()) << "no Xvfb while drawing";
  kill (tool, SIGTERM);
  int status = 0;
  waitpid (tool, &status, 0);
  ASSERT_TRUE (WIFEXITED (status));
  EXPECT_EQ (WEXITSTATUS (status), 128 + SIGTERM);
  EXPECT_FALSE (fs::exists ("/proc/" + display) &&
                processName ("/proc/" + display) == "Xvfb");
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator (folder_ ("out/warp"))) {
    EXPECT_EQ (entry.path().extension(), ".png") << entry.path();
    EXPECT_FALSE (cv::imread (entry.path().string()).empty()) << entry.path();
    ++pictures;
  }
  EXPECT_LT (pictures, 2000);
}

TEST_F (RenderTool, LiveWindowSaysThatItNeedsADisplay)
{
  const ToolRun refused = runTool (
      folder_, "env -u DISPLAY " + std::string (PCL_MSF_VIEW) + " " + folder_ ("case"));
  EXPECT_EQ (refused.status, 1);
  EXPECT_EQ (refused.errorLines(), 1) << refused.err;
  EXPECT_THAT (refused.err, HasSubstr ("DISPLAY is not set"));
}

} // namespace
