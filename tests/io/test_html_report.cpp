// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/expect_io_error.h"
#include "support/temporary_folder.h"
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/html_report.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/result_files.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;
using ::testing::Not;

long
count (const std::string& text, const std::string& part)
{
  long found = 0;
  for (std::size_t at = text.find (part); at != std::string::npos;
       at = text.find (part, at + 1))
    ++found;
  return found;
}

/** Every tag that is opened is closed (those that have to be). */
void
expectBalanced (const std::string& page)
{
  for (const char* tag : {"html",
                          "head",
                          "body",
                          "style",
                          "script",
                          "table",
                          "tr",
                          "td",
                          "th",
                          "figure",
                          "section",
                          "div",
                          "a",
                          "nav",
                          "h2"}) {
    const std::string name = tag;
    EXPECT_EQ (count (page, "<" + name + ">") + count (page, "<" + name + " "),
               count (page, "</" + name + ">"))
        << name;
  }
}

TEST (HtmlReport, PageNeedsNothingFromElsewhere)
{
  io::HtmlReport report;
  report.title = "A & B <run>";
  report.tables.push_back (
      {"scores", {"scene", "EPE"}, {{"room", "0.5"}, {"hand", ""}}});
  io::HtmlEntry entry;
  entry.name = "pair 1";
  entry.numbers = {{"segments", "12"}};
  entry.pictures = {{"/data/out/a b#1.png", "flow \"1\""}};
  entry.comparisons = {{{"/data/out/x.png", "left"}, {"/data/out/y.png", "right"}}};
  report.entries = {entry};
  const std::string page = io::htmlPage (report, "/data");
  expectBalanced (page);
  EXPECT_THAT (page, HasSubstr ("<title>A &amp; B &lt;run&gt;</title>"));
  EXPECT_THAT (page,
               HasSubstr ("src=\"out/a%20b%231.png\" alt=\"flow &quot;1&quot;\""));
  EXPECT_THAT (page, HasSubstr ("class=\"before\" src=\"out/x.png\""));
  EXPECT_THAT (page, HasSubstr ("class=\"after\" src=\"out/y.png\""));
  EXPECT_THAT (page, HasSubstr ("type=\"range\""));
  EXPECT_THAT (page, HasSubstr ("<th class=\"number\">EPE</th>"));
  EXPECT_THAT (page, HasSubstr ("<th>scene</th>"));
  for (const char* remote : {"src=\"http", "href=\"http", "@import", "url("})
    EXPECT_THAT (page, Not (HasSubstr (remote)));
  EXPECT_THAT (io::htmlPage (report, "/data/pages"),
               HasSubstr ("src=\"../out/x.png\""));
}

TEST (HtmlReport, EntriesGetATableOverAll)
{
  io::HtmlReport report;
  report.entries.resize (2);
  report.entries[0] = {"first", {{"segments", "3"}, {"seconds", "0.5"}}, {}, {}};
  report.entries[1] = {"second", {{"segments", "4"}, {"reason", "done"}}, {}, {}};
  const std::string page = io::htmlPage (report, ".");
  expectBalanced (page);
  EXPECT_THAT (page, HasSubstr ("All results"));
  EXPECT_THAT (page,
               HasSubstr ("<tr><td>second</td><td class=\"number\">4</td>"
                          "<td class=\"number\"></td><td>done</td></tr>"));
}

TEST (HtmlReport, TablesAreToBeLookedAt)
{
  io::HtmlReport report;
  report.tables.push_back (
      {"scores",
       {"scene", "EPE", "points", "unknown"},
       {{"room", "0.0054812228", "19200", ""}, {"1.2.3", "", "7", ""}}});
  const std::string page = io::htmlPage (report, ".");
  EXPECT_THAT (page, HasSubstr (">0.00548</td>"));
  EXPECT_THAT (page, HasSubstr (">19200</td>"));
  EXPECT_THAT (page, HasSubstr (">1.2.3</td>")) << "no number";
  EXPECT_THAT (page, Not (HasSubstr ("unknown"))) << "an empty column";
}

TEST (HtmlReport, ReadsCsvAfterComments)
{
  const TemporaryFolder folder;
  writeFile (folder ("t.csv"), "# results 1\r\n# a,b,c\npair,EPE\n#1,0.5\n");
  const io::HtmlTable table = io::readCsvTable (folder ("t.csv"));
  EXPECT_EQ (table.header, (std::vector<std::string>{"pair", "EPE"}));
  EXPECT_EQ (table.rows, (std::vector<std::vector<std::string>>{{"#1", "0.5"}}));
  writeFile (folder ("none.csv"), "# only this");
  EXPECT_THROW (io::readCsvTable (folder ("none.csv")), IoError);
}

TEST (HtmlReport, ReadsCsv)
{
  const TemporaryFolder folder;
  const std::string path = folder ("t.csv");
  writeFile (path, "a,\"b, c\",d\r\n1,\"say \"\"hi\"\"\",\r\n\n\"two\nlines\",x\n");
  const io::HtmlTable table = io::readCsvTable (path);
  EXPECT_EQ (table.title, "t.csv");
  EXPECT_THAT (table.header, ::testing::ElementsAre ("a", "b, c", "d"));
  ASSERT_EQ (table.rows.size(), 2U);
  EXPECT_THAT (table.rows[0], ::testing::ElementsAre ("1", "say \"hi\"", ""));
  EXPECT_THAT (table.rows[1], ::testing::ElementsAre ("two\nlines", "x", ""));
}

TEST (HtmlReport, RefusesBrokenCsv)
{
  const TemporaryFolder folder;
  const std::string path = folder ("t.csv");
  const auto read = [&path] { io::readCsvTable (path); };
  expectIoError (read, "t.csv", "");
  writeFile (path, "");
  expectIoError (read, "t.csv", "header");
  writeFile (path, "a,b\n1,2,3\n");
  expectIoError (read, "t.csv", "line 2: 3 cells");
  writeFile (path, "a,b\n1,\"open\n");
  expectIoError (read, "t.csv", "quote");
}

TEST (HtmlReport, EntryComesFromAFolder)
{
  const TemporaryFolder folder;
  io::makeFolder (folder ("runs/one"));
  SceneFlow flow;
  flow.labels = cv::Mat (4, 6, CV_32SC1, cv::Scalar (0));
  flow.segments.resize (5);
  io::writeReport (folder ("runs/one/report.json"), flow, {});
  for (const char* name :
       {"overview", "flicker_0_1_before", "flicker_0_1_after", "flow_0_2", "labels_0"})
    io::writeImage (folder ("runs/one/" + std::string (name) + ".png"),
                    cv::Mat (4, 6, CV_8UC1, cv::Scalar (7)));
  const io::HtmlEntry entry = io::entryOfFolder (folder ("runs/one"));
  EXPECT_EQ (entry.name, "one");
  EXPECT_THAT (
      entry.numbers,
      ::testing::Contains (std::pair<std::string, std::string> ("segments", "5")));
  ASSERT_EQ (entry.comparisons.size(), 1U);
  ASSERT_EQ (entry.pictures.size(), 2U) << "labels are data, no picture";
  EXPECT_EQ (entry.pictures[0].path, folder ("runs/one/overview.png"));
  EXPECT_EQ (entry.pictures[1].caption, "optical flow, frame 2");
  EXPECT_THAT (io::resultFolders (folder ("runs")),
               ::testing::ElementsAre (folder ("runs/one")));
  EXPECT_TRUE (io::resultFolders (folder ("nothing")).empty());
}

TEST (HtmlReport, EveryReferenceIsAnEntry)
{
  const TemporaryFolder folder;
  SceneFlow flow;
  flow.labels = cv::Mat (4, 6, CV_32SC1, cv::Scalar (0));
  for (const int segments : {3, 5}) {
    flow.segments.resize (segments);
    io::writeReport (
        folder ("report_" + std::to_string (segments) + ".json"), flow, {});
  }
  io::writeReport (folder ("report.json"), flow, {});
  for (const char* name : {"flow_3_4", "flow_3_44", "flow_5_4", "overview_5", "warped"})
    io::writeImage (folder (std::string (name) + ".png"), cv::Mat (4, 6, CV_8UC1));
  const auto entries = io::entriesOfFolder (folder (""));
  ASSERT_EQ (entries.size(), 2U);
  const auto has = [] (const char* segments) {
    return ::testing::Contains (
        std::pair<std::string, std::string> ("segments", segments));
  };
  EXPECT_THAT (entries[0].numbers, has ("3"));
  EXPECT_THAT (entries[1].numbers, has ("5"));
  EXPECT_NE (entries[0].name, entries[1].name);
  ASSERT_EQ (entries[0].pictures.size(), 3U) << "with what has no frame in its name";
  EXPECT_EQ (entries[0].pictures[0].caption, "optical flow");
  EXPECT_EQ (entries[0].pictures[1].caption, "optical flow, frame 44");
  ASSERT_EQ (entries[1].pictures.size(), 2U);
  EXPECT_EQ (entries[1].pictures[1].caption, "optical flow, frame 4");
}

TEST (HtmlReport, RefusesFoldersWithoutAReport)
{
  const TemporaryFolder folder;
  const auto read = [&folder] { io::entryOfFolder (folder ("")); };
  expectIoError (read, "report.json", "report");
  writeFile (folder ("report.json"), "{ \"frames\": ");
  expectIoError (read, "report.json", "report");
  writeFile (folder ("report.json"), "{ \"frames\": 3 }");
  expectIoError (read, "report.json", "none of this library");
}

} // namespace
