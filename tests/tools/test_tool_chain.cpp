// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "tools/tool_chain.h"
#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <iomanip>
#include <sstream>

// All tools one after the other, as a user runs them.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

TEST_F (ToolChain, PairsWindowsAndTrackingCanBeShown)
{
  synthesize ("seq", 4);
  const std::vector<std::pair<std::string, std::string>> modes{
      {"", "_0_3"},
      {" --window 3", "_2_3"},
      {" --track --window 3", "_0_3"},
      {" --reference 1", "_1_0"}};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const std::string result = folder_ ("result_" + std::to_string (i));
    expectSuccess ("scene_flow",
                   folder_ ("seq") + modes[i].first + " --quiet --output " + result);
    showResult (result, modes[i].second);
  }
}

TEST_F (ToolChain, AStreamCanBeWatched)
{
  if (!hasTool ("view"))
    GTEST_SKIP() << "built without VTK";
  synthesize ("seq", 4);
  watch (folder_ ("seq") + " --stream --rate 5");
}

TEST_F (ToolChain, ResultsWithoutCloudsAreReportedAndNotDrawn)
{
  synthesize ("seq", 3);
  expectSuccess ("stream",
                 folder_ ("seq") + " --as-fast-as-possible --flow --quiet --output " +
                     folder_ ("stream"));
  expectSuccess ("scene_flow",
                 folder_ ("seq") + " --outputs flow --quiet --output " +
                     folder_ ("flow"));
  for (const char* name : {"stream", "flow"})
    expectSuccess ("report",
                   folder_ (name) + " --output " + folder_ (name) + "/index.html");
  const std::string page = readFile (folder_ ("stream/index.html"));
  for (const char* row : {"tracked</th><td class=\"number\">3<",
                          "lost</th><td class=\"number\">0<",
                          "<th>frames a second</th>",
                          "<th>latency, ms</th>"})
    EXPECT_THAT (page, HasSubstr (row));
  if (hasTool ("render"))
    for (const char* name : {"stream", "flow"})
      expectRefusal ("render",
                     folder_ (name) + " --sequence " + folder_ ("seq") +
                         " --kind warped --output " + folder_ ("drawn"),
                     {"scene_flow_R_K.pcd", "--outputs"});
}

/** README's table of files is about what is written. */
TEST_F (ToolChain, WritesWhatTheReadmeLists)
{
  synthesize ("seq", 3);
  expectSuccess ("scene_flow",
                 folder_ ("seq") + " --window 2 --quiet --output " + folder_ ("out"));
  expectSuccess ("scene_flow",
                 folder_ ("seq") + " --quiet --output " + folder_ ("out"));
  std::istringstream readme (readFile (PCL_MSF_SOURCE "/README.md"));
  std::string line;
  int files = 0;
  while (std::getline (readme, line) && line != "| file | content |") {
  }
  for (std::getline (readme, line); std::getline (readme, line) && line[0] == '|';) {
    std::string last;
    for (std::size_t at = line.find ('`'); at != std::string::npos;) {
      const std::size_t end = line.find ('`', at + 1);
      std::string name = line.substr (at + 1, end - at - 1);
      if (name[0] == '.') // "`flow_0_1.flo`, `.png`"
        name = fs::path (last).replace_extension (name).string();
      EXPECT_TRUE (fs::exists (folder_ ("out/" + name))) << name;
      last = name;
      ++files;
      at = line.find ('`', end + 1);
    }
  }
  EXPECT_GT (files, 10);
}

/** The tool prints what pcl_msf_evaluate counts: an unknown flow is no motion. */
TEST_F (ToolChain, ThereIsOneEndPointError)
{
  cv::Mat flow (4, 5, CV_32FC2, cv::Scalar (1, 0));
  const cv::Mat truth (4, 5, CV_32FC2, cv::Scalar (3, 4));
  flow.row (0).setTo (cv::Scalar::all (std::nan ("")));
  flow.at<cv::Vec2f> (1, 0) = {3, 4};
  io::writeFlow (folder_ ("a.flo"), flow);
  io::writeFlow (folder_ ("t.flo"), truth);
  const evaluation::FlowErrors errors = evaluation::flowErrors (
      flow, truth, cv::Mat (truth.size(), CV_8UC1, cv::Scalar (255)));
  const ToolRun done = run ("flow_error", folder_ ("a.flo") + " " + folder_ ("t.flo"));
  ASSERT_EQ (done.status, 0) << done.err;
  std::ostringstream words;
  words << std::fixed << std::setprecision (3) << "mean " << std::setw (7) << errors.epe
        << " px, median " << std::setw (7) << errors.median << " px";
  EXPECT_THAT (done.out, HasSubstr (words.str()));
  EXPECT_THAT (done.out, HasSubstr ("known  75.00 %"));
}

TEST_F (ToolChain, FlowErrorsSayWhatCannotBeCompared)
{
  const cv::Mat truth (4, 5, CV_32FC2, cv::Scalar (3, 4));
  io::writeFlow (folder_ ("t.flo"), truth);
  io::writeFlow (folder_ ("wide.flo"), cv::Mat (4, 6, CV_32FC2, cv::Scalar (3, 4)));
  io::writeFlow (folder_ ("none.flo"),
                 cv::Mat (4, 5, CV_32FC2, cv::Scalar::all (std::nan (""))));
  io::writeImage (folder_ ("hidden.png"), cv::Mat::zeros (4, 5, CV_8UC1));
  io::writeImage (folder_ ("small.png"), cv::Mat (3, 5, CV_8UC1, cv::Scalar (255)));
  io::writeImage (folder_ ("color.png"), cv::Mat (4, 5, CV_8UC3, cv::Scalar (255)));
  io::writeImage (folder_ ("deep.png"), cv::Mat (4, 5, CV_16UC1, cv::Scalar (255)));
  const std::string t = folder_ ("t.flo") + " ";
  expectRefusal (
      "flow_error", t + folder_ ("none.flo"), {"none.flo: no pixel to compare"});
  expectRefusal ("flow_error",
                 t + t + folder_ ("hidden.png"),
                 {"t.flo: no pixel to compare", "hidden.png hides it"});
  expectRefusal ("flow_error",
                 t + folder_ ("wide.flo"),
                 {"t.flo is 5x4", "wide.flo 6x4", "give files of one size"});
  expectRefusal (
      "flow_error", t + t + folder_ ("small.png"), {"small.png is 5x3", "t.flo 5x4"});
  expectRefusal ("flow_error",
                 t + t + folder_ ("color.png"),
                 {"color.png: mask: 8 bit in 3 channel"});
  expectRefusal (
      "flow_error", t + t + folder_ ("deep.png"), {"deep.png: mask: 16 bit in 1"});
}

TEST_F (ToolChain, WithoutArgumentsToolsSayWhatIsMissing)
{
  for (const auto& [tool, missing] : {std::pair{"register", "SOURCE is required"},
                                      std::pair{"register_clouds", "REFERENCE is"},
                                      std::pair{"synthesize", "FOLDER is required"},
                                      std::pair{"view", "FOLDER"}}) {
    if (!hasTool (tool))
      continue;
    const ToolRun nothing = run (tool, "");
    pcl_msf::testing::expectRefusal (nothing, tool, {missing});
    EXPECT_NE (nothing.out, "") << tool;
  }
}

TEST_F (ToolChain, HelpSucceedsAndUnknownOptionsDoNot)
{
  for (const std::string tool : {"scene_flow",
                                 "synthesize",
                                 "register",
                                 "register_clouds",
                                 "flow_error",
                                 "evaluate",
                                 "report",
                                 "render",
                                 "view",
                                 "stream"}) {
    if (!hasTool (tool))
      continue;
    for (const char* option : {"--help", "-h"}) {
      const ToolRun help = run (tool, option);
      EXPECT_EQ (help.status, 0) << tool << " " << option;
      EXPECT_NE (help.out, "") << tool;
      EXPECT_EQ (help.err, "") << tool;
    }
    expectRefusal (tool, "--no-such-option", {});
  }
  expectRefusal ("synthesize", folder_ ("x") + " -widht 64", {"-widht"});
  expectRefusal ("synthesize", folder_ ("x") + " --frames two", {"--frames"});
  EXPECT_FALSE (fs::exists (folder_ ("x")));
}

} // namespace
