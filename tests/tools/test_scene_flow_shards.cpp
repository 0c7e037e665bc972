// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/run_tool.h"
#include <gmock/gmock.h>

#include <filesystem>
#include <set>

// A recording solved in parts is what one run gives.

namespace {

using namespace pcl_msf::testing;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

const std::string kTools = PCL_MSF_TOOLS;

class SceneFlowShards : public ::testing::Test {
protected:
  SceneFlowShards()
  {
    const ToolRun made = runTool (folder_,
                                  kTools + "/pcl_msf_synthesize " + folder_ ("seq") +
                                      " --width 96 --height 72 --frames 6 --depth png");
    EXPECT_EQ (made.status, 0) << made.err;
  }

  ToolRun
  run (const std::string& output,
       const std::string& more,
       const std::string& before = {}) const
  {
    return runTool (folder_,
                    before + kTools + "/pcl_msf_scene_flow " + folder_ ("seq") +
                        " --window 2 --quiet --threads 1 --output " + folder_ (output) +
                        " " + more);
  }
  ToolRun
  merge (const std::string& output) const
  {
    return runTool (
        folder_, kTools + "/pcl_msf_scene_flow --merge --output " + folder_ (output));
  }

  /** All files but reports, which have times, are the same, byte for byte. */
  void
  expectSame (const std::string& output, const std::string& whole) const
  {
    EXPECT_EQ (names (output), names (whole));
    for (const std::string& name : names (whole))
      if (name.rfind ("report", 0) != 0)
        EXPECT_EQ (readFile (folder_ (output) + "/" + name),
                   readFile (folder_ (whole) + "/" + name))
            << name;
  }
  std::set<std::string>
  names (const std::string& folder) const
  {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator (folder_ (folder)))
      if (entry.path().filename().string().front() != '.')
        found.insert (entry.path().filename().string());
    return found;
  }

  TemporaryFolder folder_;
};

TEST_F (SceneFlowShards, MergedAreWhatOneRunGives)
{
  ASSERT_EQ (run ("whole", "").status, 0);
  ASSERT_EQ (run ("parts", "--shard 1/2").status, 0);
  const ToolRun early = merge ("parts");
  EXPECT_EQ (early.status, 1);
  EXPECT_THAT (early.err, HasSubstr ("2 of 5 windows are missing; run shard 2/2"));
  ASSERT_EQ (run ("parts", "--shard 2/2").status, 0);
  const ToolRun merged = merge ("parts");
  ASSERT_EQ (merged.status, 0) << merged.err;
  EXPECT_FALSE (fs::exists (folder_ ("parts/shards")));
  expectSame ("parts", "whole");
}

TEST_F (SceneFlowShards, ARestartDoesOnlyWhatIsMissing)
{
  const std::string shard = folder_ ("out/shards/1_of_1/");
  ASSERT_EQ (run ("out", "--shard 1/1").status, 0);
  const std::string log = readFile (shard + "windows.json");
  const auto before = fs::last_write_time (shard + "flow_0_1.flo");
  ASSERT_EQ (run ("out", "--shard 1/1").status, 0);
  EXPECT_EQ (readFile (shard + "windows.json"), log);
  EXPECT_EQ (fs::last_write_time (shard + "flow_0_1.flo"), before);
  const ToolRun other = run ("out", "--shard 1/1 --loss l2");
  EXPECT_EQ (other.status, 1);
  EXPECT_THAT (other.err, HasSubstr ("holds another run"));
  EXPECT_EQ (readFile (shard + "windows.json"), log);
}

TEST_F (SceneFlowShards, GnuParallelRunsThem)
{
  if (!hasProgram ("parallel"))
    GTEST_SKIP() << "GNU parallel is not here";
  ASSERT_EQ (run ("whole", "").status, 0);
  const ToolRun r =
      run ("parts", "--shard {}/3 ::: 1 2 3", "parallel --will-cite -j2 ");
  ASSERT_EQ (r.status, 0) << r.err;
  ASSERT_EQ (merge ("parts").status, 0);
  expectSame ("parts", "whole");
}

TEST_F (SceneFlowShards, MpiRunsThem)
{
  if (!hasProgram ("mpirun"))
    GTEST_SKIP() << "Open MPI is not here";
  ASSERT_EQ (run ("whole", "").status, 0);
  const ToolRun r =
      run ("parts", "--shard auto", "mpirun --allow-run-as-root --oversubscribe -n 2 ");
  ASSERT_EQ (r.status, 0) << r.err;
  ASSERT_EQ (merge ("parts").status, 0);
  expectSame ("parts", "whole");
}

TEST_F (SceneFlowShards, SlurmsVariablesChooseThem)
{
  ASSERT_EQ (run ("whole", "").status, 0);
  for (const std::string id : {"4", "5"})
    ASSERT_EQ (run ("parts",
                    "--shard auto",
                    "SLURM_ARRAY_TASK_ID=" + id +
                        " SLURM_ARRAY_TASK_MIN=4 SLURM_ARRAY_TASK_COUNT=2 ")
                   .status,
               0);
  ASSERT_EQ (merge ("parts").status, 0);
  expectSame ("parts", "whole");
}

TEST_F (SceneFlowShards, WhatCannotBeMergedIsRefused)
{
  EXPECT_THAT (merge ("nowhere").err, HasSubstr ("holds no shard"));
  EXPECT_THAT (run ("x", "--track --shard 1/2").err,
               HasSubstr ("--track excludes --shard"));
  EXPECT_THAT (run ("x", "--shard 3/2").err, HasSubstr ("--shard: 3/2"));
}

} // namespace
