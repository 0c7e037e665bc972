// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "tools/tool_chain.h"

// What the tools write side by side, and into each other's folders.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

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

} // namespace
