// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/command_line.h"
#include "evaluate/cloud_table.h"
#include "evaluate/pair_table.h"
#include "support/evaluation.h"
#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/errors.h>

#include <cmath>

// The bytes of both kinds of results, which other programs read, and earlier runs left.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using pcl_msf::testing::expectIoError;
using pcl_msf::testing::makeRow;
using pcl_msf::testing::messageOf;
using pcl_msf::testing::TemporaryFolder;
using pcl_msf::testing::writeFile;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kClouds =
    "# pcl_msf_evaluate, clouds without a grid, 2\n"
    "# settings bodies seed=1 noise_seeds=1\n"
    "# methods zero,msf\n"
    "# shard 2/3\n"
    "# cases 8\n"
    "case,method,points,mean,median,p95,within_10_mm,converged,seconds,number\n"
    "a, \"b\",msf,2000,0.012346,0.001000,0.100000,0.1235,1,1.235,4\n"
    "c,zero,0,nan,nan,nan,nan,0,0.000,7\n";

CloudTable
cloudTable ()
{
  const double none = std::nan ("");
  return {"bodies seed=1 noise_seeds=1",
          {"zero", "msf"},
          8,
          {2, 3},
          {{"a, \"b\"", "msf", {0.0123456, 0.001, 0.1, 0.12346, 2000}, true, 1.2346, 4},
           {"c", "zero", {none, none, none, none, 0}, false, 0.0, 7}}};
}

TEST (CloudFiles, AreOfTheseBytes) { EXPECT_EQ (csvText (cloudTable()), kClouds); }

TEST (CloudFiles, AreReadAgain)
{
  const TemporaryFolder folder;
  const std::string path = folder ("r.csv");
  writeFile (path, kClouds);
  EXPECT_TRUE (isCloudCsv (path));
  const CloudTable table = readCloudCsv (path);
  EXPECT_EQ (table.settings, "bodies seed=1 noise_seeds=1");
  EXPECT_EQ (table.methods, (std::vector<std::string>{"zero", "msf"}));
  EXPECT_EQ (table.cases, 8);
  EXPECT_EQ (table.shard.text(), "2/3");
  ASSERT_EQ (table.rows.size(), 2U);
  const CloudRow& row = table.rows[0];
  EXPECT_EQ (row.name, "a, \"b\"") << "names are as they are";
  EXPECT_EQ (row.method, "msf");
  EXPECT_EQ (row.score.points, 2000);
  EXPECT_EQ (row.score.mean, 0.012346);
  EXPECT_EQ (row.score.within, 0.1235);
  EXPECT_TRUE (row.converged);
  EXPECT_EQ (row.seconds, 1.235);
  EXPECT_EQ (row.number, 4);
  EXPECT_TRUE (std::isnan (table.rows[1].score.mean));
  EXPECT_FALSE (table.rows[1].converged);
  EXPECT_EQ (csvText (table), kClouds);
}

TEST (CloudFiles, MayBeSavedByAnEditor)
{
  const TemporaryFolder folder;
  std::string text = "\xEF\xBB\xBF";
  for (const char c : kClouds.substr (0, kClouds.size() - 1)) // no end of the last line
    text += c == '\n' ? "\r\n" : std::string (1, c);
  writeFile (folder ("r.csv"), text);
  EXPECT_TRUE (isCloudCsv (folder ("r.csv")));
  EXPECT_EQ (csvText (readCloudCsv (folder ("r.csv"))), kClouds);
}

TEST (CloudFiles, DamageAndOtherKindsAreRefused)
{
  const TemporaryFolder folder;
  const std::string path = folder ("r.csv");
  const auto expect = [&] (const char* part, const char* other, const char* what) {
    std::string text = kClouds;
    writeFile (path, text.replace (text.find (part), std::string (part).size(), other));
    expectIoError ([&] { readCloudCsv (path); }, "r.csv", what);
  };
  expect ("grid, 2", "grid, 1", "line 1: '# pcl_msf_evaluate, clouds");
  EXPECT_FALSE (isCloudCsv (path));
  expect ("# methods", "# ways", "line 3: '# methods ' is expected");
  expect ("2/3", "auto", "shard: 'auto'");
  expect ("cases 8", "cases -8", "cases: '-8'");
  expect (",p95", "", "line 6: columns");
  expect ("c,zero,0", "c,0", "line 8: there are 9 fields where 10");
  expect ("0.001000", "0.00x", "line 7: median: '0.00x'");
  expect ("0.001000", "", "line 7: median: ''");
  writeFile (path, "# pcl_msf_evaluate results 1\n");
  EXPECT_FALSE (isCloudCsv (path));
  EXPECT_FALSE (isCloudCsv (folder ("none.csv")));
}

TEST (PairFiles, AreOfTheseBytes)
{
  const std::string head = headText (ResultFile{"1.2.3", "methods=a,b", {2, 3}, 7, {}});
  EXPECT_THAT (head,
               StartsWith ("# pcl_msf_evaluate results 1\n"
                           "# version 1.2.3\n"
                           "# settings methods=a,b\n"
                           "# shard 2/3\n"
                           "# pairs 7\n"
                           "pair,dataset,sequence,from,to,method,points,coverage,"));
  EXPECT_THAT (head,
               EndsWith (",sec_result,peak_mb,motion_ax,motion_ay,motion_az,motion_tx,"
                         "motion_ty,motion_tz,true_motion_ax,true_motion_ay,"
                         "true_motion_az,true_motion_tx,true_motion_ty,"
                         "true_motion_tz\n"));
  Row row = makeRow (7, "msf:loss=l1", 1.0 / 3.0);
  row.sequence = "a, \"b\"";
  row.from = 12;
  row.score.points = 1e6;
  row.score.motion = {0.1, -0.2, 1e-17, 1e5, 0, INFINITY};
  const std::string line = rowText (row);
  EXPECT_THAT (line,
               StartsWith ("7,generated,\"a, \"\"b\"\"\",12,1,msf:loss=l1,1e+06,,,"
                           "0.3333333333333333,,"));
  EXPECT_THAT (line, EndsWith (",0.1,-0.2,1e-17,1e+05,0,,,,,,,\n"));
}

TEST (PairFiles, OtherVersionsAreRefused)
{
  const TemporaryFolder folder;
  const std::string path = folder ("r.csv");
  std::string text = headText (ResultFile{"1", "s", {}, 1, {}});
  text.replace (text.find ("results 1"), 9, "results 0");
  writeFile (path, text);
  expectIoError (
      [&] { readResults (path); }, "r.csv: line 1", "results 1' is expected");
  writeFile (path, kClouds);
  expectIoError (
      [&] { readResults (path); }, "r.csv: line 1", "results 1' is expected");
}

} // namespace
