// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "evaluate/cloud_run.h"
#include "support/expect_refusal.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/folders.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <cmath>
#include <sstream>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using pcl_msf::testing::readFile;
using pcl_msf::testing::runTool;
using pcl_msf::testing::TemporaryFolder;
using pcl_msf::testing::ToolRun;
using pcl_msf::testing::writeFile;
using ::testing::HasSubstr;
using ::testing::Not;

TEST (EvaluateClouds, ScoresPointsWithTruth)
{
  const Eigen::Vector3f none = Eigen::Vector3f::Constant (NAN);
  CloudCase data;
  data.source.assign (5, Eigen::Vector3f::Zero());
  data.truth.assign (4, Eigen::Vector3f (0.03F, 0.0F, 0.0F));
  data.truth.push_back (none); // cut off
  const std::vector<Eigen::Vector3f> warped{
      {0.03F, 0.0F, 0.0F}, {0.03F, 0.008F, 0.0F}, {0.03F, 0.0F, 0.02F}, none, none};
  const CloudScore score = scoreClouds (data, warped);
  EXPECT_EQ (score.points, 4);
  EXPECT_NEAR (score.mean, (0.0 + 0.008 + 0.02 + 0.03) / 4.0, 1e-7)
      << "an unknown point has not moved";
  EXPECT_NEAR (score.median, 0.008, 1e-7);
  EXPECT_EQ (score.within, 0.5);
  data.truth.assign (5, none);
  EXPECT_TRUE (std::isnan (scoreClouds (data, warped).mean));
}

class EvaluateCloudsTool : public ::testing::Test {
protected:
  ToolRun
  run (const std::string& arguments) const
  {
    return runTool (folder_,
                    PCL_MSF_TOOLS "/pcl_msf_evaluate " + arguments +
                        " --threads 1 --quiet");
  }
  void
  expectError (const std::string& arguments, const std::string& text) const
  {
    pcl_msf::testing::expectRefusal (run (arguments), arguments, {text});
  }
  /** Two cases; the second one's target is too small. */
  void
  writeCases () const
  {
    synthetic::BodyOptions options;
    options.points = 2000;
    io::makeFolder (folder_ ("cases/a"));
    synthetic::writeBody (synthesizeBody (options), folder_ ("cases/a"));
    synthetic::BodyClouds small = synthesizeBody (options);
    small.target.resize (10);
    io::makeFolder (folder_ ("cases/b"));
    synthetic::writeBody (small, folder_ ("cases/b"));
  }

  TemporaryFolder folder_;
};

TEST_F (EvaluateCloudsTool, ScoresFoldersBesidePclsOwn)
{
  writeCases();
  const ToolRun one =
      run ("clouds " + folder_ ("cases/a") + " --csv " + folder_ ("t.csv"));
  ASSERT_EQ (one.status, 0) << one.err;
  for (const char* method : {"zero", "icp", "gicp", "msf"})
    EXPECT_THAT (one.out, HasSubstr (method));
  EXPECT_THAT (readFile (folder_ ("t.csv")), HasSubstr ("\n.,msf,2000,"));
  const ToolRun all = run ("clouds " + folder_ ("cases") + " --methods zero,msf");
  EXPECT_EQ (all.status, 1) << "one case failed";
  EXPECT_THAT (all.err, HasSubstr ("b: the target has"));
  EXPECT_THAT (all.out, HasSubstr ("| a "));
  EXPECT_THAT (all.out, Not (HasSubstr ("icp")));
}

TEST_F (EvaluateCloudsTool, ShardsMergeToWhatOneRunWrites)
{
  for (const char* name : {"a", "b", "c"}) {
    synthetic::BodyOptions options;
    options.points = 500;
    options.seed = static_cast<unsigned> (name[0]);
    io::makeFolder (folder_ (std::string ("cases/") + name));
    synthetic::writeBody (synthesizeBody (options),
                          folder_ (std::string ("cases/") + name));
  }
  const std::string command = "clouds " + folder_ ("cases") + " --methods zero,gicp";
  ASSERT_EQ (run (command + " --csv " + folder_ ("all.csv")).status, 0);
  for (const char* shard : {"1", "2"}) {
    const ToolRun r =
        run (command + " --shard " + shard + "/2 --csv " + folder_ ("part_%.csv"));
    ASSERT_EQ (r.status, 0) << r.err;
  }
  EXPECT_THAT (readFile (folder_ ("part_2.csv")), HasSubstr ("\nb,gicp,"));
  EXPECT_THAT (readFile (folder_ ("part_2.csv")), Not (HasSubstr ("\nc,gicp,")));
  const std::string merge =
      "--merge --csv " + folder_ ("merged.csv") + " --json " + folder_ ("merged.json ");
  const ToolRun merged =
      run (merge + folder_ ("part_2.csv") + " " + folder_ ("part_1.csv"));
  ASSERT_EQ (merged.status, 0) << merged.err;
  const auto withoutTimes = [this] (const char* name) {
    std::string text;
    std::istringstream lines (readFile (folder_ (name)));
    for (std::string line; std::getline (lines, line);)
      if (line.front() != '#') // what was run, in how many parts
        text += line.substr (0, line.rfind (',', line.rfind (',') - 1)) +
                line.substr (line.rfind (',')) + "\n";
    return text;
  };
  EXPECT_EQ (withoutTimes ("merged.csv"), withoutTimes ("all.csv"));
  EXPECT_THAT (readFile (folder_ ("merged.json")), HasSubstr ("\"cases\": 3"));
  EXPECT_THAT (readFile (folder_ ("merged.json")), HasSubstr ("\"within_10_mm\""));
  const ToolRun part = run (merge + folder_ ("part_1.csv"));
  EXPECT_EQ (part.status, 1);
  EXPECT_THAT (part.err, HasSubstr ("missing: case 2 of 3"));
  expectError (merge + folder_ ("part_1.csv") + " " + folder_ ("part_1.csv"),
               "give each shard once");
  ASSERT_EQ (run ("clouds " + folder_ ("cases") + " --methods zero --csv " +
                  folder_ ("zero.csv"))
                 .status,
             0);
  expectError (merge + folder_ ("part_1.csv") + " " + folder_ ("zero.csv"),
               "different runs");
}

TEST_F (EvaluateCloudsTool, SaysWhatItCannotTake)
{
  expectError ("clouds " + folder_ ("."), "no folder with source.ply");
  expectError ("clouds", "needs a path");
  expectError ("bodies --methods dis", "none for clouds");
  expectError ("bodies --ablation", "--ablation");
  writeFile (folder_ ("mine.csv"), "something else\n");
  expectError ("bodies --csv " + folder_ ("mine.csv"), "give another name");
  EXPECT_EQ (readFile (folder_ ("mine.csv")), "something else\n");
}

} // namespace
