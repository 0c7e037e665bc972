// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/run_tool.h"
#include <gmock/gmock.h>
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

const std::string kTools = PCL_MSF_TOOLS;

class ToolChain : public ::testing::Test {
protected:
  ToolRun
  run (const std::string& tool, const std::string& arguments) const
  {
    return runTool (folder_,
                    "env -u DISPLAY " + kTools + "/pcl_msf_" + tool + " " + arguments);
  }
  void
  expectSuccess (const std::string& tool, const std::string& arguments) const
  {
    const ToolRun done = run (tool, arguments);
    EXPECT_EQ (done.status, 0) << tool << " " << arguments << "\n" << done.err;
  }
  void
  expectRefusal (const std::string& tool,
                 const std::string& arguments,
                 const std::vector<std::string>& words) const
  {
    const ToolRun refused = run (tool, arguments);
    EXPECT_GT (refused.status, 0) << tool << " " << arguments;
    EXPECT_EQ (refused.errorLines(), 1) << refused.err;
    for (const std::string& word : words)
      EXPECT_THAT (refused.err, HasSubstr (word));
  }
  void
  synthesize (const std::string& name, int frames, const std::string& more = {}) const
  {
    expectSuccess ("synthesize",
                   folder_ (name) + " --width 160 --height 120 --depth png --frames " +
                       std::to_string (frames) + more);
  }
  static bool
  hasTool (const std::string& name)
  {
    return fs::exists (kTools + "/pcl_msf_" + name);
  }

  /** Report, renders and the live window of a result. \param pair as in its names */
  void
  showResult (const std::string& result, const std::string& pair) const
  {
    expectSuccess ("report", result + " --output " + result + "/index.html");
    const std::string page = readFile (result + "/index.html");
    for (const char* kind : {"flow", "residual", "overlay", "occlusion"})
      EXPECT_THAT (page, HasSubstr ("src=\"" + (kind + pair) + ".png\""));
    EXPECT_THAT (page, HasSubstr ("<th>stop reason</th>"));
    if (!hasTool ("render"))
      return;
    expectSuccess ("render",
                   result + " --sequence " + folder_ ("seq") +
                       " --quiet --kind after_tints --output " + result);
    EXPECT_TRUE (fs::exists (result + "/after_tints.png"));
    expectSuccess ("report", result + " --output " + result + "/index.html");
    EXPECT_THAT (readFile (result + "/index.html"), HasSubstr ("\"after_tints.png\""));
    const std::string display = folder_ ("display");
    fs::remove (display);
    const ToolRun seen = runTool (
        folder_,
        "{ Xvfb -displayfd 3 -screen 0 640x480x24 -nolisten tcp 3>" + display +
            " 2>/dev/null & x=$!; until [ -s " + display +
            " ]; do sleep 0.05; done; DISPLAY=:$(cat " + display +
            ") timeout --preserve-status 4 " + kTools + "/pcl_msf_view " + result +
            " --sequence " + folder_ ("seq") + "; s=$?; kill $x; wait $x; exit $s; }");
    EXPECT_EQ (seen.status, 128 + 15) << "it was open until it was told to end";
    EXPECT_EQ (seen.err, "");
  }

  TemporaryFolder folder_;
};

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

TEST_F (ToolChain, ResultsWithoutCloudsAreReportedAndNotDrawn)
{
  synthesize ("seq", 3);
  expectSuccess ("stream",
                 folder_ ("seq") + " --as-fast-as-possible --flow --quiet --output " +
                     folder_ ("stream"));
  expectSuccess ("scene_flow",
                 folder_ ("seq") + " --outputs flow --quiet --output " +
                     folder_ ("flow"));
  fs::create_directory (folder_ ("cloud"));
  writeFile (folder_ ("cloud/report.json"), "{}"); // as of pcl_msf_register
  fs::copy (PCL_MSF_SOURCE "/LICENSE", folder_ ("cloud/registered.pcd"));
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
    for (const char* name : {"stream", "flow", "cloud"})
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

TEST_F (ToolChain, AShorterSequenceLeavesNoFramesOfALongerOne)
{
  synthesize ("seq", 4);
  writeFile (folder_ ("seq/notes.txt"), "mine");
  synthesize ("seq", 2, " -scene articulated");
  for (const char* name : {"color_2.png", "depth_3.png", "gt/flow_0_2.flo"})
    EXPECT_FALSE (fs::exists (folder_ (std::string ("seq/") + name))) << name;
  EXPECT_TRUE (fs::exists (folder_ ("seq/gt/flow_0_1.flo")));
  EXPECT_EQ (readFile (folder_ ("seq/notes.txt")), "mine");
  fs::create_directory (folder_ ("real"));
  writeFile (folder_ ("real/color_7.jpg"), "a recording");
  expectRefusal ("synthesize",
                 folder_ ("real") + " --width 160 --height 120",
                 {"real/color_7.jpg", "give another folder"});
  EXPECT_EQ (filesIn (folder_ ("real")), 1U);
}

TEST_F (ToolChain, SintelScenesStandBesideEachOther)
{
  synthesize ("seq", 3, " --layout sintel --scene hand");
  synthesize ("seq", 2, " --layout sintel --scene street");
  synthesize ("seq", 2, " --layout sintel --scene hand");
  EXPECT_EQ (filesIn (folder_ ("seq/clean/hand")), 2U);
  EXPECT_EQ (filesIn (folder_ ("seq/clean/street")), 2U);
}

TEST_F (ToolChain, RendersOfAnotherResultDoNotSurvive)
{
  if (!hasTool ("render"))
    GTEST_SKIP() << "no VTK";
  synthesize ("seq", 2);
  synthesize ("other", 2, " --seed 2");
  const auto render = [this] (const std::string& what) {
    expectSuccess ("render", what + " --quiet --output " + folder_ ("out"));
  };
  render (folder_ ("seq") + " --kind warped");
  render (folder_ ("seq") + " --kind arrows --animation warp --pictures 4");
  render (folder_ ("seq") + " --animation warp --pictures 2");
  EXPECT_TRUE (fs::exists (folder_ ("out/warped.png"))) << "of the same result";
  EXPECT_EQ (filesIn (folder_ ("out/warp")), 2U);
  writeFile (folder_ ("out/arrows.png"), "changed by the user");
  render (folder_ ("other") + " --kind segments");
  EXPECT_FALSE (fs::exists (folder_ ("out/warped.png")));
  EXPECT_FALSE (fs::exists (folder_ ("out/warp")));
  EXPECT_EQ (readFile (folder_ ("out/arrows.png")), "changed by the user");
  expectRefusal ("render",
                 folder_ ("other") + " --kind arrows --output " + folder_ ("out"),
                 {"out/arrows.png"});
  expectRefusal ("render",
                 folder_ ("seq") + " --kind warped --output " + folder_ ("seq"),
                 {"is the recording"});
}

TEST_F (ToolChain, RendersGoWithTheResultThatTheyShow)
{
  if (!hasTool ("render"))
    GTEST_SKIP() << "no VTK";
  synthesize ("seq", 2);
  for (const char* name : {"out", "two\nlines"}) {
    const std::string out = "'" + folder_ (name) + "'";
    const std::string picture = folder_ (name) + "/warped.png";
    expectSuccess ("scene_flow", folder_ ("seq") + " --quiet --output " + out);
    expectSuccess ("render", out + " --quiet --kind warped --output " + out);
    ASSERT_TRUE (fs::exists (picture));
    expectSuccess ("scene_flow", folder_ ("seq") + " --quiet --output " + out);
    EXPECT_FALSE (fs::exists (picture)) << "of a result that is gone";
  }
}

/** Every tool that writes a file refuses one that it reads. */
TEST_F (ToolChain, NoOutputIsAnInput)
{
  synthesize ("seq", 2);
  expectSuccess ("scene_flow",
                 folder_ ("seq") + " --quiet --output " + folder_ ("out"));
  const std::string flow = folder_ ("out/flow_0_1.flo");
  const std::string truth = folder_ ("seq/gt/flow_0_1.flo");
  const std::string seen = folder_ ("seq/gt/visible_0_1.png");
  const std::string report = folder_ ("out/report.json");
  const std::string cloud = folder_ ("out/warped_0_1.pcd");
  fs::create_hard_link (seen, folder_ ("hard.png"));
  fs::create_symlink (cloud, folder_ ("soft.pcd"));
  fs::create_hard_link (report, folder_ ("hard.json"));
  const std::string mask = readFile (seen), points = readFile (cloud);
  expectRefusal ("flow_error",
                 flow + " " + truth + " " + seen + " " + folder_ ("hard.png"),
                 {"hard.png", seen});
  expectRefusal ("register_clouds",
                 cloud + " " + folder_ ("out/scene_flow_0_1.pcd") + " " +
                     folder_ ("soft.pcd"),
                 {"soft.pcd", cloud});
  expectRefusal ("report",
                 folder_ ("out") + " --output " + folder_ ("hard.json"),
                 {"hard.json", report});
  const std::string csv = folder_ ("a.csv");
  expectSuccess ("evaluate",
                 "generated --size 64x48 --scenes static_room --motion easy --sensor "
                 "none --methods zero --quiet --csv " +
                     csv);
  const std::string rows = readFile (csv);
  expectRefusal (
      "evaluate", "--merge --csv " + csv + " " + folder_ ("./a.csv"), {csv, "input"});
  expectRefusal ("evaluate", "--merge --json " + csv + " " + csv, {csv, "input"});
  expectRefusal ("evaluate",
                 "generated --size 64x48 --methods zero --json " + seen,
                 {seen, "give another name"});
  EXPECT_EQ (readFile (seen), mask);
  EXPECT_EQ (readFile (cloud), points);
  EXPECT_EQ (readFile (csv), rows);
}

TEST_F (ToolChain, APageReplacesOnlyAPage)
{
  writeFile (folder_ ("t.csv"), "a,b\n1,2\n");
  writeFile (folder_ ("mine.html"), "<p>mine</p>");
  const std::string table = "--csv " + folder_ ("t.csv") + " --output ";
  expectRefusal ("report", table + folder_ ("mine.html"), {"mine.html"});
  expectRefusal ("report", table + folder_ ("t.csv"), {"t.csv", "input"});
  expectSuccess ("report", table + folder_ ("page.html"));
  expectSuccess ("report", table + folder_ ("page.html"));
  EXPECT_EQ (readFile (folder_ ("mine.html")), "<p>mine</p>");
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
