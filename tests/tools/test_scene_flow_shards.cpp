// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/run_tool.h"
#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <set>

// A recording solved in parts is what one run gives.

namespace {

using namespace pcl_msf::testing;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

const std::string kTools = PCL_MSF_TOOLS;

class SceneFlowShards : public ::testing::Test {
protected:
  static void
  SetUpTestSuite ()
  {
    shared_ = std::make_unique<TemporaryFolder>();
    const ToolRun made = runTool (*shared_,
                                  kTools + "/pcl_msf_synthesize " + (*shared_) ("seq") +
                                      " --width 96 --height 72 --frames 6 --depth png");
    ASSERT_EQ (made.status, 0) << made.err;
    ASSERT_EQ (solve (*shared_, "whole", "", "").status, 0);
  }
  static void
  TearDownTestSuite ()
  {
    shared_.reset();
  }

  static ToolRun
  solve (const TemporaryFolder& folder,
         const std::string& output,
         const std::string& more,
         const std::string& before)
  {
    return runTool (folder,
                    before + kTools + "/pcl_msf_scene_flow " + (*shared_) ("seq") +
                        " --window 2 --quiet --threads 1 --output " + folder (output) +
                        " " + more);
  }
  ToolRun
  run (const std::string& output,
       const std::string& more,
       const std::string& before = {}) const
  {
    return solve (folder_, output, more, before);
  }
  ToolRun
  merge (const std::string& output) const
  {
    return runTool (
        folder_, kTools + "/pcl_msf_scene_flow --merge --output " + folder_ (output));
  }

  /** All files but reports, which have times, are those of one run, byte for byte. */
  void
  expectWhole (const std::string& output) const
  {
    const std::string whole = (*shared_) ("whole");
    EXPECT_EQ (names (folder_ (output)), names (whole));
    for (const std::string& name : names (whole)) {
      if (name.rfind ("report", 0) == 0)
        continue;
      EXPECT_EQ (readFile (folder_ (output) + "/" + name),
                 readFile (whole + "/" + name))
          << name;
    }
  }
  static std::set<std::string>
  names (const std::string& folder)
  {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator (folder))
      if (entry.path().filename().string().front() != '.')
        found.insert (entry.path().filename().string());
    return found;
  }

  static std::unique_ptr<TemporaryFolder> shared_; ///< seq, and whole: of one run
  TemporaryFolder folder_;
};

std::unique_ptr<TemporaryFolder> SceneFlowShards::shared_;

TEST_F (SceneFlowShards, MergedAreWhatOneRunGives)
{
  ASSERT_EQ (run ("parts", "--shard 1/2").status, 0);
  const ToolRun early = merge ("parts");
  EXPECT_EQ (early.status, 1);
  EXPECT_THAT (early.err, HasSubstr ("2 of 5 windows are missing; run shard 2/2"));
  ASSERT_EQ (run ("parts", "--shard 2/2").status, 0);
  const ToolRun merged = merge ("parts");
  ASSERT_EQ (merged.status, 0) << merged.err;
  EXPECT_FALSE (fs::exists (folder_ ("parts/shards")));
  expectWhole ("parts");
}

TEST_F (SceneFlowShards, TheRecordingMayBeSpelledInAnyWay)
{
  const std::string rest =
      " --window 2 --quiet --threads 1 --output " + folder_ ("parts") + " --shard ";
  const std::string tool = kTools + "/pcl_msf_scene_flow ";
  const std::string seq = (*shared_) ("seq");
  ASSERT_EQ (runTool (folder_, tool + seq + "/" + rest + "1/3").status, 0);
  ASSERT_EQ (runTool (folder_, "cd " + seq + " && " + tool + "." + rest + "2/3").status,
             0);
  ASSERT_EQ (runTool (folder_, tool + seq + rest + "3/3").status, 0);
  const ToolRun merged = merge ("parts");
  ASSERT_EQ (merged.status, 0) << merged.err;
  expectWhole ("parts");
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
  const ToolRun r =
      run ("parts", "--shard {}/3 ::: 1 2 3", "parallel --will-cite -j2 ");
  ASSERT_EQ (r.status, 0) << r.err;
  ASSERT_EQ (merge ("parts").status, 0);
  expectWhole ("parts");
}

TEST_F (SceneFlowShards, MpiRunsThem)
{
  if (!hasProgram ("mpirun"))
    GTEST_SKIP() << "Open MPI is not here";
  const ToolRun r =
      run ("parts", "--shard auto", "mpirun --allow-run-as-root --oversubscribe -n 2 ");
  ASSERT_EQ (r.status, 0) << r.err;
  ASSERT_EQ (merge ("parts").status, 0);
  expectWhole ("parts");
}

TEST_F (SceneFlowShards, SlurmsVariablesChooseThem)
{
  for (const std::string id : {"4", "5"})
    ASSERT_EQ (run ("parts",
                    "--shard auto",
                    "SLURM_ARRAY_TASK_ID=" + id +
                        " SLURM_ARRAY_TASK_MIN=4 SLURM_ARRAY_TASK_COUNT=2 ")
                   .status,
               0);
  ASSERT_EQ (merge ("parts").status, 0);
  expectWhole ("parts");
}

TEST_F (SceneFlowShards, WhatCannotBeMergedIsRefused)
{
  EXPECT_THAT (merge ("nowhere").err, HasSubstr ("holds no shard"));
  EXPECT_THAT (run ("x", "--track --shard 1/2").err,
               HasSubstr ("--shard excludes --track"));
  EXPECT_THAT (run ("x", "--shard 3/2").err, HasSubstr ("--shard: 3/2"));
}

} // namespace
