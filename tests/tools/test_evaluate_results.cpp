// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/command_line.h"
#include "evaluate/merge.h"
#include "evaluate/pair_table.h"
#include "evaluate/result_store.h"
#include "support/evaluation.h"
#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/errors.h>

#include <cmath>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using pcl_msf::testing::makeRow;
using pcl_msf::testing::messageOf;
using pcl_msf::testing::TemporaryFolder;
using ::testing::HasSubstr;

/** Shard i of n of a run of pairs with two methods. */
ResultFile
makeShard (int i, int n, std::size_t pairs)
{
  ResultFile file{"1.2.3", "methods=a,b", {i, n}, pairs, {}};
  for (std::size_t pair = 0; pair < pairs; ++pair)
    if (file.shard.has (pair))
      for (const char* method : {"a", "b"})
        file.rows.push_back (makeRow (pair, method, 0.1 * static_cast<double> (pair)));
  return file;
}

std::vector<WorkItem>
makeWork (std::size_t pairs)
{
  std::vector<WorkItem> work;
  for (std::size_t pair = 0; pair < pairs; ++pair)
    work.push_back ({pair, nullptr, "scene_" + std::to_string (pair), 0, 1});
  return work;
}

TEST (ResultLines, RoundTripIsExact)
{
  Row row = makeRow (7, "msf:loss=l1", 1.0 / 3.0);
  row.sequence = "a, \"b\"";
  row.score.epe3d_all = 1e-17;
  row.score.motion = {0.1, -0.2, 0.3, 1e5, 0, 2};
  const std::string line = rowText (row);
  const Row back = parseRow (line.substr (0, line.size() - 1));
  EXPECT_EQ (back.pair, 7u);
  EXPECT_EQ (back.sequence, row.sequence);
  EXPECT_EQ (back.method, row.method);
  EXPECT_EQ (back.score.epe_visible, 1.0 / 3.0);
  EXPECT_EQ (back.score.epe3d_all, 1e-17);
  EXPECT_EQ (back.score.motion, row.score.motion);
  EXPECT_TRUE (std::isnan (back.score.rms_all));
  EXPECT_EQ (rowText (back), line);
}

TEST (ResultLines, DamageIsNamed)
{
  std::string line = rowText (makeRow (0, "a", 0.25));
  line.pop_back();
  EXPECT_THAT (messageOf<InvalidInput> ([&] { parseRow (line + ",1"); }),
               HasSubstr ("fields"));
  line.replace (line.find ("0.25"), 4, "0.2x");
  EXPECT_THAT (messageOf<InvalidInput> ([&] { parseRow (line); }),
               HasSubstr ("epe_visible: '0.2x'"));
}

TEST (ResultFiles, DamageIsNamedWithFileAndLine)
{
  const TemporaryFolder folder;
  const std::string path = folder ("r.csv");
  const auto read = [&] { readResults (path); };
  pcl_msf::testing::expectIoError (read, "r.csv", "check the path");
  pcl_msf::testing::writeFile (path, "hello\nworld\n");
  pcl_msf::testing::expectIoError (read, "r.csv", "pcl_msf_evaluate");
  ResultFile file = makeShard (1, 1, 2);
  std::string text = headText (file) + "0,generated,half\n";
  pcl_msf::testing::writeFile (path, text);
  pcl_msf::testing::expectIoError (read, "r.csv: line 7", "fields");
  text = headText (file);
  text.replace (text.find ("# pairs 2"), 9, "# pairs x");
  pcl_msf::testing::writeFile (path, text);
  pcl_msf::testing::expectIoError (read, "r.csv", "pairs");
  text = headText (file);
  text.replace (text.find ("1/1"), 3, "3/1");
  pcl_msf::testing::writeFile (path, text);
  pcl_msf::testing::expectIoError (read, "r.csv", "shard");
  text = headText (file);
  text.replace (text.find (",coverage"), 9, "");
  pcl_msf::testing::writeFile (path, text);
  pcl_msf::testing::expectIoError (read, "r.csv", "expected");
}

TEST (ResultFiles, AHalfWrittenLastLineIsDropped)
{
  const TemporaryFolder folder;
  const ResultFile file = makeShard (1, 1, 3);
  writeResults (folder ("r.csv"), file);
  std::string text = pcl_msf::testing::readFile (folder ("r.csv"));
  pcl_msf::testing::writeFile (folder ("r.csv"), text.substr (0, text.size() - 20));
  EXPECT_EQ (readResults (folder ("r.csv")).rows.size(), 5u);
}

TEST (ResultFiles, LinesMayEndAsOnWindows)
{
  const TemporaryFolder folder;
  std::string text;
  for (const char c : headText (makeShard (1, 1, 1)) + rowText (makeRow (0, "a", 1)))
    text += c == '\n' ? "\r\n" : std::string (1, c);
  pcl_msf::testing::writeFile (folder ("r.csv"), "\xEF\xBB\xBF" + text);
  const ResultFile file = readResults (folder ("r.csv"));
  EXPECT_EQ (file.settings, "methods=a,b");
  ASSERT_EQ (file.rows.size(), 1U);
  EXPECT_EQ (file.rows[0].method, "a");
}

TEST (ResultStores, ARunGoesOnWhereItWasKilled)
{
  const TemporaryFolder folder;
  const std::string path = folder ("r.csv");
  const ResultFile head{"1", "s", {}, 3, {}};
  {
    ResultStore store (path, head, makeWork (3), {"a", "b"});
    store.add ({makeRow (2, "a", 1), makeRow (2, "b", 2)});
    store.add ({makeRow (0, "a", 3), makeRow (0, "b", 4)});
    // Killed while it writes pair 1: one row whole, one half.
    appendToDisk (path, rowText (makeRow (1, "a", 5)) + "1,generated,sce");
  }
  ResultStore store (path, head, makeWork (3), {"a", "b"});
  EXPECT_TRUE (store.has (0));
  EXPECT_FALSE (store.has (1));
  EXPECT_TRUE (store.has (2));
  store.add ({makeRow (1, "a", 5), makeRow (1, "b", 6)});
  EXPECT_EQ (store.finish().rows.size(), 6u);
  const ResultFile file = readResults (path);
  ASSERT_EQ (file.rows.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ (file.rows[i].pair, i / 2);
  EXPECT_EQ (file.rows[3].score.epe_visible, 6.0);
}

TEST (ResultStores, AnotherRunsFileIsLeftAlone)
{
  const TemporaryFolder folder;
  const std::string path = folder ("r.csv");
  const std::vector<std::string> methods{"a", "b"};
  ResultFile head{"1", "s", {}, 2, {}};
  ResultStore (path, head, makeWork (2), methods)
      .add ({makeRow (0, "a", 1), makeRow (0, "b", 1)});
  const std::string before = pcl_msf::testing::readFile (path);
  const auto open = [&] (const ResultFile& h, std::size_t pairs) {
    return messageOf<UsageError> (
        [&] { ResultStore store (path, h, makeWork (pairs), methods); });
  };
  EXPECT_THAT (open ({"2", "s", {}, 2, {}}, 2), HasSubstr ("version"));
  EXPECT_THAT (open ({"1", "t", {}, 2, {}}, 2), HasSubstr ("settings (s)"));
  EXPECT_THAT (open ({"1", "s", {2, 2}, 2, {}}, 2), HasSubstr ("shard"));
  EXPECT_THAT (open ({"1", "s", {}, 3, {}}, 3), HasSubstr ("pairs"));
  EXPECT_EQ (pcl_msf::testing::readFile (path), before);
}

TEST (Merging, ShardsGiveTheWholeInOrder)
{
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  for (const int i : {3, 1, 2}) {
    paths.push_back (folder (std::to_string (i)));
    writeResults (paths.back(), makeShard (i, 3, 7));
  }
  const Merged merged = mergeResults (paths);
  EXPECT_TRUE (merged.missing.empty());
  writeResults (folder ("merged"), merged.results);
  writeResults (folder ("whole"), makeShard (1, 1, 7));
  EXPECT_EQ (pcl_msf::testing::readFile (folder ("merged")),
             pcl_msf::testing::readFile (folder ("whole")));
}

TEST (Merging, MissingPairsAreNamedAndTheRestIsKept)
{
  const TemporaryFolder folder;
  ResultFile first = makeShard (1, 3, 7);
  first.rows.resize (4); // pairs 0 and 3 of 0, 3, 6
  writeResults (folder ("1"), first);
  writeResults (folder ("3"), makeShard (3, 3, 7));
  const Merged merged = mergeResults ({folder ("1"), folder ("3")});
  EXPECT_EQ (
      merged.missing,
      (std::vector<std::string>{"shard 1/3: 1 of 3 pairs", "shard 2/3: 2 of 2 pairs"}));
  EXPECT_EQ (merged.results.rows.size(), 8u);
  EXPECT_EQ (merged.results.shard.text(), "1/1");
}

TEST (Merging, FilesOfDifferentRunsAndDuplicatesAreRefused)
{
  const TemporaryFolder folder;
  writeResults (folder ("1"), makeShard (1, 2, 4));
  const auto merge = [&] (const ResultFile& other) {
    writeResults (folder ("2"), other);
    return messageOf<UsageError> ([&] { mergeResults ({folder ("1"), folder ("2")}); });
  };
  ResultFile other = makeShard (2, 2, 4);
  other.version = "9";
  EXPECT_THAT (merge (other), HasSubstr ("versions"));
  other = makeShard (2, 2, 4);
  other.settings = "methods=a";
  EXPECT_THAT (merge (other), HasSubstr ("settings"));
  EXPECT_THAT (merge (makeShard (2, 3, 4)), HasSubstr ("division"));
  EXPECT_THAT (merge (makeShard (1, 2, 4)), HasSubstr ("pair 0 (scene_0) is in both"));
}

} // namespace
