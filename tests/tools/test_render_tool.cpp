// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/render_case.h"
#include <gmock/gmock.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

TEST_F (RenderCase, DrawsEveryKindOfFrames)
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
TEST_F (RenderCase, WarpedCloudLooksLikeTheCurrentImage)
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

TEST_F (RenderCase, DrawsStoredResultsWithViewsAndSizes)
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

TEST_F (RenderCase, TrajectoriesGoThroughAllFramesUpToTheCurrentOne)
{
  writeResult ({0, 0.2, 0}, 1);
  writeResult ({0.3, 0, 0}, 2);
  const std::string command = folder_ ("result") +
                              " --frame 2 --kind trajectories --arrow-scale 1 "
                              "--output " +
                              folder_ ("out");
  ASSERT_EQ (run (command).status, 0);
  const cv::Mat bent = picture ("trajectories.png");
  std::filesystem::remove (folder_ ("result/scene_flow_0_1.pcd"));
  ASSERT_EQ (run (command).status, 0) << "frames that are not there are left out";
  EXPECT_GT (cv::norm (bent, picture ("trajectories.png"), cv::NORM_L1),
             5.0 * static_cast<double> (bent.total()));
  expectRefusal (command + " --window 3", "scene_flow_0_1.pcd");
}

TEST_F (RenderCase, RefusesWhatItCannotDo)
{
  expectRefusal (folder_ ("nothing"), "there is none of that name");
  expectRefusal (folder_ (""), "camera.txt");
  expectRefusal (folder_ ("case") + " --kind portrait", "--kind: 'portrait'");
  expectRefusal (folder_ ("case") + " --size 9000x100", "--size");
  expectRefusal (folder_ ("case") + " --frame 7", "there is no frame 7");
  expectRefusal (folder_ ("case") + " --view user", "--eye");
  expectRefusal (folder_ ("case") + " --gif", "ffmpeg");
  expectRefusal (folder_ ("case") + " --mp4", "--animation");
  expectRefusal (folder_ ("case") + " --colour 1", "no such option");
  expectRefusal (folder_ ("case") + " --output /proc/nowhere --kind warped",
                 "cannot be made");
  EXPECT_EQ (run ("--help").status, 0);
}

TEST_F (RenderCase, SaysWhenWhatItComputesIsNoResult)
{
  const auto draw = [this] (const std::string& more) {
    return run (folder_ ("case") + " --kind segments --quiet --output " +
                folder_ ("out") + more);
  };
  EXPECT_EQ (draw ("").err, "");
  expectRefusal (folder_ ("case") + " --kind segments --depth-scale 1 --output " +
                     folder_ ("out"),
                 "with --depth-scale 1; give units per metre, for example 1000");
  const cv::Size size (SmallScene::kWidth, SmallScene::kHeight);
  io::writeImage (folder_ ("case/color_1.png"), cv::Mat (size, CV_8UC3, {9, 9, 9}));
  io::writeDepth (
      folder_ ("case/depth_1.png"), cv::Mat (size, CV_32FC1, cv::Scalar (0.1)), 5000.0);
  const ToolRun covered = draw ("");
  EXPECT_EQ (covered.status, 3);
  EXPECT_EQ (covered.errorLines(), 1) << covered.err;
  EXPECT_THAT (covered.err, HasSubstr ("frame 0 to 1: not converged ("));
}

TEST_F (RenderCase, NamesThePackageThatIsMissing)
{
  writeResult();
  const ToolRun refused =
      runTool (folder_,
               "env -u DISPLAY PATH=/nonexistent " + tool_ + " " + folder_ ("result") +
                   " --kind warped --output " + folder_ ("out"));
  pcl_msf::testing::expectRefusal (refused, "warped", {"install it (Debian: xvfb)"});
}

TEST_F (RenderCase, AnimationsAreNumberedPictures)
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

TEST_F (RenderCase, FramesOfAnotherSizeAreRefused)
{
  writeResult();
  const cv::Size half (SmallScene::kWidth / 2, SmallScene::kHeight / 2);
  for (const char* k : {"0", "1"})
    io::writeDepth (folder_ ("case/depth_") + k + ".png",
                    cv::Mat (half, CV_32FC1, cv::Scalar (2.0)),
                    5000.0);
  std::filesystem::remove (folder_ ("case/color_0.png"));
  std::filesystem::remove (folder_ ("case/color_1.png"));
  io::writeCamera (folder_ ("case/camera.txt"),
                   {scene_.camera, half.width, half.height, 5000.0});
  expectRefusal (folder_ ("result") + " --sequence " + folder_ ("case") +
                     " --kind after --output " + folder_ ("out"),
                 "--sequence: its frames are ");
}

TEST_F (RenderCase, LiveWindowRefusesInOneLine)
{
  const auto refused = [this] (const char* words) {
    const ToolRun done = runTool (
        folder_, "env -u DISPLAY " PCL_MSF_TOOLS "/pcl_msf_view " + folder_ ("case"));
    EXPECT_EQ (done.status, 1);
    EXPECT_EQ (done.errorLines(), 1) << done.err;
    EXPECT_THAT (done.err, HasSubstr (words));
  };
  refused ("DISPLAY is not set");
  std::filesystem::remove (folder_ ("case/depth_1.png"));
  std::filesystem::remove (folder_ ("case/color_1.png"));
  refused ("two are needed");
  const ToolRun stream = runTool (folder_,
                                  "env -u DISPLAY " PCL_MSF_TOOLS "/pcl_msf_view " +
                                      folder_ ("case") + " --stream --rate 5");
  EXPECT_EQ (stream.status, 1);
  EXPECT_THAT (stream.err, HasSubstr ("two are needed"));
  const std::string view = PCL_MSF_TOOLS "/pcl_msf_view ";
  const ToolRun live = runTool (folder_, view + "no-such --stream --grabber openni2");
  EXPECT_EQ (live.status, 1);
  EXPECT_THAT (live.err, HasSubstr ("'no-such'"));
  EXPECT_THAT (runTool (folder_, view + "no-such --grabber pcd").err,
               HasSubstr ("--stream"));
}

} // namespace
