// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "evaluate/run_progress.h"
#include "evaluate/summary.h"
#include "evaluate/tables.h"
#include "support/evaluation.h"

#include <cmath>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using pcl_msf::testing::makeRow;
using ::testing::HasSubstr;

TEST (Tables, BestIsBoldAndAveragesStandBelow)
{
  std::vector<Row> rows{makeRow (0, "a", 1.0), makeRow (0, "b", 0.5)};
  rows.push_back (makeRow (1, "a", 0.25));
  rows.push_back (makeRow (1, "b", 0.75));
  const std::string text = allTables (rows);
  EXPECT_THAT (text, HasSubstr ("| scene_0 |     1.000 | **0.500** |"));
  EXPECT_THAT (text, HasSubstr ("| scene_1 | **0.250** |     0.750 |"));
  EXPECT_THAT (text, HasSubstr ("| mean    |     0.625 |     0.625 |"));
}

TEST (Tables, ManyPairsAreShownBySequence)
{
  std::vector<Row> rows;
  for (std::size_t pair = 0; pair < 80; ++pair)
    rows.push_back (makeRow (pair, "a", pair < 40 ? 1.0 : 3.0 + (pair % 2)));
  for (Row& row : rows)
    row.sequence = row.pair < 40 ? "first" : "second";
  const std::string text = allTables (rows);
  EXPECT_THAT (text, HasSubstr ("| first  | **1.000** |"));
  EXPECT_THAT (text, HasSubstr ("| second | **3.500** |"));
  EXPECT_LT (text.size(), 2000u);
}

TEST (Tables, ThePapersSintelFiguresStandBesideOurs)
{
  std::vector<Row> rows{makeRow (0, "msf", 0.5), makeRow (1, "rigid", 0.25)};
  EXPECT_EQ (sintelTable (rows), "");
  rows[0].sequence = "alley_1";
  rows[0].score.epe_all = 0.75;
  rows.push_back (rows[0]); // the mean of a sequence's pairs
  rows.back().pair = 1;
  rows.back().score.epe_all = 0.5;
  rows[1].sequence = "sleeping_2";
  rows[1].score.epe_all = 0.375;
  const std::string text = sintelTable (rows);
  EXPECT_THAT (text, HasSubstr ("| 2.461 |      0.740 |    msf |     0.625 |"));
  EXPECT_THAT (text, HasSubstr ("| 1.136 |      0.308 |  rigid |     0.375 |"));
}

TEST (Tables, AblationIsRelativeToTheDefault)
{
  std::vector<Row> rows{makeRow (0, "msf", 2.0), makeRow (0, "msf:loss=l2", 3.0)};
  rows[1].score.sec = 0.25;
  EXPECT_THAT (ablationTable (rows), HasSubstr ("50.0 | -50.0 |"));
  rows.pop_back();
  EXPECT_EQ (ablationTable (rows), "");
}

TEST (Paths, AreChainedFromSuccessivePairs)
{
  std::vector<Row> rows;
  for (int k = 0; k < 3; ++k) {
    Row row = makeRow (k, "msf", 0.0);
    row.sequence = "walk";
    row.from = k;
    row.to = k + 1;
    row.score.true_motion = {0, 0, 0, -0.1, 0, 0.05 * k};
    row.score.motion = row.score.true_motion;
    row.score.motion[3] = k == 1 ? -0.13 : -0.1;
    rows.push_back (row);
  }
  const auto paths = pathErrors (rows);
  ASSERT_EQ (paths.size(), 1u);
  EXPECT_EQ (paths[0].poses, 4);
  EXPECT_NEAR (paths[0].rpe_m, 0.03 / std::sqrt (3.0), 1e-12);
  EXPECT_NEAR (paths[0].rpe_deg, 0.0, 1e-9);
  EXPECT_GT (paths[0].ate_m, 0.001);
  EXPECT_LT (paths[0].ate_m, 0.03);
  rows[1].score.motion[0] = std::nan ("");
  EXPECT_TRUE (pathErrors (rows).empty());
}

TEST (Durations, AreSaidInUnitsThatOneCanRead)
{
  EXPECT_EQ (durationText (45.2), "45 s");
  EXPECT_EQ (durationText (600), "10 min");
  EXPECT_EQ (durationText (2 * 3600 + 5 * 60), "2 h 05 min");
}

} // namespace
