// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "tools/tool_chain.h"

#include <array>

// Which folders pcl_msf_scene_flow reads and writes, as a user names them.

namespace {

using namespace pcl_msf::testing;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

class SceneFlowFolders : public ToolChain {
protected:
  ToolRun
  runIn (const std::string& folder, const std::string& arguments) const
  {
    return runTool (folder_,
                    "cd " + folder_ (folder) + " && " + tools() +
                        "/pcl_msf_scene_flow " + arguments + " --outputs flow --quiet");
  }
};

/** However the folder is spelled, results are called after it and stand outside. */
TEST_F (SceneFlowFolders, TheStandardOutputIsNeverInTheRecording)
{
  synthesize ("seq", 2);
  fs::create_directory (folder_ ("seq/inside"));
  fs::create_directory (folder_ ("elsewhere"));
  const std::size_t before = filesIn (folder_ ("seq"));
  const std::vector<std::array<std::string, 3>> runs{
      {"seq", ".", "seq_scene_flow"},
      {"seq/inside", "..", "seq_scene_flow"},
      {"seq", "../seq/", "seq_scene_flow"},
      {"elsewhere", "../seq/.", "elsewhere/seq_scene_flow"},
      {"elsewhere", "../seq/", "elsewhere/seq_scene_flow"}};
  for (const auto& [from, recording, result] : runs) {
    fs::remove_all (folder_ (result));
    const ToolRun done = runIn (from, recording);
    EXPECT_EQ (done.status, 0) << done.err;
    EXPECT_TRUE (fs::exists (folder_ (result + "/report.json")))
        << from << " " << recording;
    EXPECT_EQ (filesIn (folder_ ("seq")), before);
  }
}

TEST_F (SceneFlowFolders, SaysThatAWindowIsTheWholeRecording)
{
  synthesize ("seq", 2);
  const ToolRun done = runIn ("seq", ". --window 9");
  EXPECT_EQ (done.status, 0) << done.err;
  EXPECT_THAT (done.err, HasSubstr ("warning: --window: 9, but there are 2 frames"));
}

TEST_F (SceneFlowFolders, AnOutputThatIsAFileIsNamed)
{
  synthesize ("seq", 2);
  writeFile (folder_ ("taken"), "mine");
  for (const char* path : {"taken", "taken/below"})
    pcl_msf::testing::expectRefusal (
        runIn ("seq", ". --output " + folder_ (path)),
        path,
        {folder_ (path), "'" + folder_ ("taken") + "' is a file"});
  pcl_msf::testing::expectRefusal (run ("synthesize", folder_ ("taken")),
                                   "synthesize",
                                   {"'" + folder_ ("taken") + "' is a file"});
  EXPECT_EQ (readFile (folder_ ("taken")), "mine");
}

} // namespace
