// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "evaluate/pair_table.h"
#include "support/expect_refusal.h"
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <map>

namespace {

using namespace pcl_msf::tool;
using pcl_msf::testing::hasProgram;
using pcl_msf::testing::readFile;
using pcl_msf::testing::runTool;
using pcl_msf::testing::TemporaryFolder;
using pcl_msf::testing::ToolRun;
using pcl_msf::testing::writeFile;
using ::testing::HasSubstr;

const std::string kTiny = " generated --scenes multi_body,bending --size 160x120"
                          " --threads 1 ";

class EvaluateTool : public ::testing::Test {
protected:
  ToolRun
  run (const std::string& arguments, const std::string& before = {}) const
  {
    return runTool (folder_, before + PCL_MSF_TOOLS "/pcl_msf_evaluate" + arguments);
  }

  /** The rows of a result file with what differs from run to run left out. */
  std::string
  stable (const std::string& name) const
  {
    ResultFile file = readResults (folder_ (name));
    for (Row& row : file.rows)
      for (const Column& c : columns())
        if (c.is_time)
          row.score.*c.value = std::nan ("");
    std::string text;
    for (const Row& row : file.rows)
      text += rowText (row);
    return text;
  }

  void
  expectError (const std::string& arguments, const std::string& text) const
  {
    const ToolRun r = run (arguments);
    pcl_msf::testing::expectRefusal (r, arguments, {text});
    EXPECT_EQ (r.out, "");
  }

  /** Three parts give what one run gave. */
  void
  expectMerged (const std::string& parts, const std::string& whole) const
  {
    std::string files;
    for (const char* i : {"1", "2", "3"})
      files += " " + folder_ (parts + i + ".csv");
    const ToolRun r = run (" --merge" + files + " --csv " + folder_ ("m.csv"));
    ASSERT_EQ (r.status, 0) << r.err;
    EXPECT_EQ (stable ("m.csv"), stable (whole));
    EXPECT_THAT (r.out, HasSubstr ("bending_easy_kinect"));
  }

  TemporaryFolder folder_;
};

TEST_F (EvaluateTool, ScoresAllMethods)
{
  const ToolRun r =
      run (kTiny + "--motion easy --sensor none --methods all --quiet --csv " +
           folder_ ("a.csv") + " --json " + folder_ ("a.json"));
  ASSERT_EQ (r.status, 0) << r.err;
  EXPECT_EQ (r.err, "");
  EXPECT_THAT (r.out, HasSubstr ("| multi_body_easy_none | "));
  const ResultFile file = readResults (folder_ ("a.csv"));
  std::map<std::string, Score> of;
  for (const Row& row : file.rows)
    if (row.sequence == "multi_body_easy_none")
      of[row.method] = row.score;
  EXPECT_EQ (of.size() * 2, file.rows.size());
  for (const char* other :
       {"zero", "rigid", "gicp", "independent", "dis_fast", "dis_medium"}) {
    ASSERT_EQ (of.count (other), 1u) << other;
    EXPECT_GT (of[other].epe_visible, 0.0) << other;
    EXPECT_GT (of[other].epe3d_visible, 0.0) << other;
    EXPECT_LT (of[other].epe_visible, 2.0 * of["zero"].epe_visible) << other;
  }
  const Score& own = of["msf"];
  EXPECT_LT (own.epe_visible, 0.1);
  EXPECT_GT (own.coverage, 0.95);
  EXPECT_GT (own.ari, 0.9);
  EXPECT_LT (own.segment_trans_median, 5.0);
  EXPECT_LT (own.ego_trans, 10.0);
  EXPECT_GT (own.sec, 0.0);
  EXPECT_GT (own.peak_mb, 10.0);
  EXPECT_EQ (of["rigid"].segments, 1.0);
  EXPECT_EQ (of["zero"].motion, (std::array<double, 6>{}));
  const std::string json = readFile (folder_ ("a.json"));
  for (const char* key : {"\"summary\"", "\"rows\"", "\"median\"", "\"settings\""})
    EXPECT_THAT (json, HasSubstr (key));
}

TEST_F (EvaluateTool, DeviationsSortErrorsBetterThanResiduals)
{
  const ToolRun r =
      run (kTiny + "--methods msf --sensor kinect,stereo --csv " + folder_ ("d.csv"));
  ASSERT_EQ (r.status, 0) << r.err;
  double own = 0.0, residual = 0.0;
  const ResultFile file = readResults (folder_ ("d.csv"));
  ASSERT_EQ (file.rows.size(), 8U);
  for (const Row& row : file.rows) {
    own += row.score.ause;
    residual += row.score.ause_residual;
    EXPECT_GT (row.score.ause, 0.0) << row.sequence;
  }
  EXPECT_LT (own, 0.5 * residual);
}

TEST_F (EvaluateTool, ShardsGiveWhatOneRunGives)
{
  const std::string what = kTiny + "--motion easy --methods msf,zero --quiet --csv ";
  ASSERT_EQ (run (what + folder_ ("all.csv")).status, 0);
  for (const std::string i : {"0", "1", "2"}) {
    const std::string variables =
        "OMPI_COMM_WORLD_SIZE=3 OMPI_COMM_WORLD_RANK=" + i + " ";
    ASSERT_EQ (run (what + folder_ ("part_%.csv") + " --shard auto", variables).status,
               0);
  }
  expectMerged ("part_", "all.csv");
}

TEST_F (EvaluateTool, GnuParallelRunsShards)
{
  if (!hasProgram ("parallel"))
    GTEST_SKIP() << "GNU parallel is not here";
  const std::string what = kTiny + "--motion easy --methods zero --quiet ";
  ASSERT_EQ (run (what + "--csv " + folder_ ("all.csv")).status, 0);
  const ToolRun r =
      runTool (folder_,
               "parallel --will-cite -j2 " PCL_MSF_TOOLS "/pcl_msf_evaluate" + what +
                   "--shard {}/3 --csv " + folder_ ("part_{}.csv") + " ::: 1 2 3");
  ASSERT_EQ (r.status, 0) << r.err;
  expectMerged ("part_", "all.csv");
}

TEST_F (EvaluateTool, MpiRunsShards)
{
  if (!hasProgram ("mpirun"))
    GTEST_SKIP() << "Open MPI is not here";
  const std::string what = kTiny + "--motion easy --methods zero --quiet ";
  ASSERT_EQ (run (what + "--csv " + folder_ ("all.csv")).status, 0);
  const ToolRun r =
      runTool (folder_,
               "mpirun --allow-run-as-root --oversubscribe -n 3 " PCL_MSF_TOOLS
               "/pcl_msf_evaluate" +
                   what + "--shard auto --csv " + folder_ ("part_%.csv"));
  ASSERT_EQ (r.status, 0) << r.err;
  expectMerged ("part_", "all.csv");
}

TEST_F (EvaluateTool, AKilledRunLosesNothingThatIsDone)
{
  const std::string csv = folder_ ("r.csv");
  const std::string what =
      kTiny + "--motion easy --methods msf,dis_fast --quiet --csv " + csv;
  ASSERT_EQ (run (what).status, 0);
  const std::string whole = stable ("r.csv");
  std::filesystem::remove (csv);
  // Killed as soon as the file has a row.
  const std::string command =
      std::string ("bash -c '") + PCL_MSF_TOOLS "/pcl_msf_evaluate" + what +
      " >/dev/null & p=$!; while kill -0 $p && ! grep -q ^0, " + csv +
      " 2>/dev/null; do sleep 0.02; done; kill -9 $p; wait'";
  runTool (folder_, command);
  const ResultFile part = readResults (csv);
  EXPECT_GE (part.rows.size(), 2u);
  const double first = part.rows[0].score.sec;
  ASSERT_EQ (run (what).status, 0);
  EXPECT_EQ (stable ("r.csv"), whole);
  EXPECT_EQ (readResults (csv).rows[0].score.sec, first); // was not done again
}

TEST_F (EvaluateTool, AnInterruptedRunKeepsItsRowsAndSaysSo)
{
  const std::string csv = folder_ ("r.csv");
  const std::string what = // all scenes: far more to do than the first pair
      " generated --size 160x120 --threads 1 --methods msf --quiet --csv " + csv;
  const std::string command = std::string ("bash -c '") +
                              PCL_MSF_TOOLS "/pcl_msf_evaluate" + what +
                              " & p=$!; while kill -0 $p && ! grep -q ^0, " + csv +
                              " 2>/dev/null; do sleep 0.02; done; kill $p; wait $p'";
  const ToolRun r = runTool (folder_, command);
  EXPECT_EQ (r.status, 128 + 15);
  EXPECT_THAT (r.err, HasSubstr ("interrupted"));
  EXPECT_GE (readResults (csv).rows.size(), 1u);
}

TEST_F (EvaluateTool, TrueLabelsAndStartTellStagesApart)
{
  const ToolRun r =
      run (kTiny + "--motion large --sensor none --quiet --csv " + folder_ ("a.csv") +
           " --methods msf,msf:labels=true,msf:labels=cut:start=true");
  ASSERT_EQ (r.status, 0) << r.err;
  const ResultFile file = readResults (folder_ ("a.csv"));
  ASSERT_EQ (file.rows.size(), 6u);
  EXPECT_EQ (file.rows[1].score.segments, 6.0); // bodies of multi_body
  EXPECT_EQ (file.rows[4].score.segments, 2.0); // room and sheet
  EXPECT_GE (file.rows[2].score.segments, file.rows[0].score.segments);
  EXPECT_LT (file.rows[5].score.epe_visible, file.rows[4].score.epe_visible);
  const ToolRun same =
      run (kTiny + "--motion large --sensor none --quiet --csv " + folder_ ("b.csv") +
           " --methods msf --labels cut --start true");
  ASSERT_EQ (same.status, 0) << same.err;
  EXPECT_EQ (readResults (folder_ ("b.csv")).rows[0].score.epe_visible,
             file.rows[2].score.epe_visible);
}

TEST_F (EvaluateTool, TrueCutsFollowTheFinestLevel)
{
  const ToolRun r =
      run (kTiny + "--motion large --sensor none --quiet --csv " + folder_ ("a.csv") +
           " --methods msf:finest-level=1,msf:finest-level=1:labels=cut,zero");
  ASSERT_EQ (r.status, 0) << r.err;
  const ResultFile file = readResults (folder_ ("a.csv"));
  ASSERT_EQ (file.rows.size(), 6u);
  EXPECT_GE (file.rows[1].score.segments, file.rows[0].score.segments);
  EXPECT_LT (file.rows[1].score.epe_visible, 0.25 * file.rows[2].score.epe_visible);
}

TEST_F (EvaluateTool, PathsPairsAndAblation)
{
  const ToolRun r =
      run (" generated --scenes static_room --motion easy --sensor none --size 160x120"
           " --threads 1 --frames 4 --ablation --csv " +
           folder_ ("a.csv"));
  ASSERT_EQ (r.status, 0) << r.err;
  EXPECT_THAT (r.out, HasSubstr ("ATE mm"));
  EXPECT_THAT (r.out, HasSubstr ("norm in place of Huber"));
  const ResultFile file = readResults (folder_ ("a.csv"));
  ASSERT_EQ (file.rows.size(), 9u);
  EXPECT_EQ (file.rows[8].from, 2);
  EXPECT_EQ (file.rows[8].to, 3);
  EXPECT_LT (file.rows[6].score.epe_visible, 0.1); // truth of later frames, too
  ASSERT_EQ (run (" generated --scenes static_room --motion easy --sensor none --size "
                  "160x120 --threads 1 --frames 5 --pairs 0-k --step 2 --methods zero "
                  "--csv " +
                  folder_ ("b.csv"))
                 .status,
             0);
  const ResultFile wide = readResults (folder_ ("b.csv"));
  ASSERT_EQ (wide.rows.size(), 2u);
  EXPECT_EQ (wide.rows[1].from, 0);
  EXPECT_EQ (wide.rows[1].to, 4);
}

TEST_F (EvaluateTool, MistakesAreOneLineThatNamesTheRemedy)
{
  expectError (" moon /tmp", "generated");
  expectError (" cases", "needs a path");
  expectError (" cases " + folder_ ("none"), "none");
  expectError (" generated more", "one word too many");
  expectError (" generated --methods msf,msf", "twice");
  expectError (" generated --methods sift", "no method 'sift'");
  expectError (" generated --scenes moon", "--scenes");
  expectError (" generated --size 16", "--size");
  expectError (" generated --size 4x4", "width");
  expectError (" generated --frames 1 --methods zero", "--frames");
  expectError (" generated --shard 5/4", "5/4");
  expectError (" generated --shard 1/4", "--csv");
  expectError (" generated --step 0", "--step");
  expectError (" generated --jobs 4", "GNU parallel");
  expectError (" generated --speed", "no such option");
  expectError (" generated --tuning start.luck=1", "no tuned value 'start.luck'");
  expectError (" generated --tuning start.lost=2", "from 0 to 1");
  expectError (" --merge", "no files");
  writeFile (folder_ ("x.csv"), "a,b\n1,2\n");
  expectError (" --merge " + folder_ ("x.csv"), "x.csv: line 1");
}

TEST_F (EvaluateTool, AnotherRunsFileIsNotTouched)
{
  const std::string csv = folder_ ("a.csv");
  const std::string what =
      kTiny + "--motion easy --sensor none --methods zero --csv " + csv;
  ASSERT_EQ (run (what).status, 0);
  const std::string before = readFile (csv);
  expectError (what + " --seed 2", "other settings");
  expectError (what + " --tuning start.lost=0.6", "other settings");
  EXPECT_EQ (readFile (csv), before);
}

TEST_F (EvaluateTool, AMergeWithALostShardKeepsTheRestAndCanBeCompleted)
{
  const std::string what =
      kTiny + "--motion easy --methods zero,dis_fast --quiet --csv ";
  ASSERT_EQ (run (what + folder_ ("1.csv") + " --shard 1/2").status, 0);
  const ToolRun r =
      run (" --merge --csv " + folder_ ("m.csv") + " " + folder_ ("1.csv"));
  pcl_msf::testing::expectRefusal (r, "--merge", {"missing: shard 2/2: 2 of 2 pairs"});
  ASSERT_EQ (run (what + folder_ ("m.csv")).status, 0);
  EXPECT_EQ (readResults (folder_ ("m.csv")).rows.size(), 8u);
}

TEST_F (EvaluateTool, HelpNamesOptionsMethodsAndColumns)
{
  const ToolRun r = run (" --help");
  EXPECT_EQ (r.status, 0);
  for (const char* word :
       {"--shard", "sintel", "msf:KEY=VALUE", "gicp", "epe3d_visible"})
    EXPECT_THAT (r.out, HasSubstr (word));
}

} // namespace
