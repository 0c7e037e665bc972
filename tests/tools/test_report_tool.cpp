// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/expect_refusal.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/result_files.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

const std::string kTool = std::string (PCL_MSF_TOOLS "/pcl_msf_report") + " ";

TEST (ReportTool, WritesAPageOverFoldersAndTables)
{
  const TemporaryFolder folder;
  SceneFlow flow;
  flow.labels = cv::Mat (4, 6, CV_32SC1, cv::Scalar (0));
  for (const char* name : {"runs/a", "runs/b"}) {
    io::makeFolder (folder (name));
    io::writeReport (folder (std::string (name) + "/report.json"), flow, {});
  }
  writeFile (folder ("t.csv"), "scene,EPE\nroom,0.25\n");
  const ToolRun done =
      runTool (folder,
               kTool + folder ("runs") + " --csv " + folder ("t.csv") +
                   " --title Mine --output " + folder ("page/index.html"));
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_THAT (done.out, HasSubstr ("results 2, tables 1"));
  const std::string page = readFile (folder ("page/index.html"));
  EXPECT_THAT (page, HasSubstr ("<h1>Mine</h1>"));
  EXPECT_THAT (page, HasSubstr ("<td class=\"number\">0.25</td>"));
  EXPECT_THAT (page, HasSubstr ("id=\"entry1\""));
}

TEST (ReportTool, LeavesOutReportsThatAreNotItsOwn)
{
  const TemporaryFolder folder;
  SceneFlow flow;
  flow.labels = cv::Mat (4, 6, CV_32SC1, cv::Scalar (0));
  for (const char* name : {"runs/damaged", "runs/foreign", "runs/own"})
    io::makeFolder (folder (name));
  io::writeReport (folder ("runs/own/report.json"), flow, {});
  writeFile (folder ("runs/foreign/report.json"), "{ \"frames\": 3 }");
  writeFile (folder ("runs/damaged/report.json"), "{ \"frames\": ");
  const std::string output = " --output " + folder ("index.html");
  const ToolRun done = runTool (folder, kTool + folder ("runs") + output);
  EXPECT_EQ (done.status, 0);
  EXPECT_THAT (done.out, HasSubstr ("results 1, tables 0"));
  EXPECT_EQ (done.errorLines(), 2) << done.err;
  for (const char* name : {"runs/damaged/report.json", "runs/foreign/report.json"})
    EXPECT_THAT (done.err, HasSubstr ("warning: left out: " + folder (name)));
  std::filesystem::remove (folder ("index.html"));
  const ToolRun none = runTool (folder, kTool + folder ("runs/foreign") + output);
  EXPECT_EQ (none.status, 1);
  EXPECT_THAT (none.err, HasSubstr ("no report of this library is left"));
  EXPECT_FALSE (std::filesystem::exists (folder ("index.html")));
}

TEST (ReportTool, RefusesInOneLine)
{
  const TemporaryFolder folder;
  for (const std::string& arguments : {std::string(),
                                       folder (""),
                                       "--csv " + folder ("none.csv"),
                                       std::string ("--x")}) {
    expectRefusal (runTool (folder, kTool + arguments), arguments);
  }
  writeFile (folder ("t.csv"), "a,b\n1,2\n");
  const std::string to_folder =
      "--csv " + folder ("t.csv") + " --output " + folder ("");
  expectRefusal (
      runTool (folder, kTool + to_folder), to_folder, {"is a folder; give a file"});
  EXPECT_EQ (runTool (folder, kTool + "--help").status, 0);
}

} // namespace
