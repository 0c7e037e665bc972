// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/standard_streams.h"
#include "support/run_tool.h"
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

// What tools print has nobody who reads it, or no place.

namespace {

using namespace pcl_msf::testing;
using ::testing::HasSubstr;

const std::string kTools = PCL_MSF_TOOLS "/pcl_msf_";

struct Call {
  const char* tool;
  std::string arguments;
  std::string result; ///< a file that it writes
};

/** Small inputs first; each call may use what those before it wrote. */
std::vector<Call>
callsOfTools (const TemporaryFolder& folder)
{
  const std::string seq = folder ("seq");
  const std::string flow = folder ("flow/flow_0_1.flo");
  return {
      {"synthesize",
       seq + " --width 160 --height 120 --depth png --frames 3",
       "seq/camera.txt"},
      {"scene_flow", seq + " --output " + folder ("flow"), "flow/flow_0_1.flo"},
      {"stream",
       seq + " --as-fast-as-possible --output " + folder ("out"),
       "out/trajectory.txt"},
      {"evaluate",
       "cases " + seq + " --methods zero --json " + folder ("a.json"),
       "a.json"},
      {"flow_error",
       flow + " " + flow + " " + folder ("flow/visibility_0_1.png ") +
           folder ("error.png"),
       "error.png"},
      {"report", folder ("flow") + " --output " + folder ("index.html"), "index.html"}};
}

/** As with "| head -1", but sure: nobody reads from the beginning. */
TEST (StandardStreams, AReaderWhoGoesAwayTakesNoResultsAlong)
{
  const TemporaryFolder folder;
  for (const Call& call : callsOfTools (folder)) {
    const ToolRun done =
        runTool (folder,
                 "{ sleep 0.2; " + kTools + call.tool + " " + call.arguments +
                     "; echo $? >" + folder ("status") + "; } | true");
    EXPECT_EQ (readFile (folder ("status")), "0\n") << call.tool;
    EXPECT_EQ (done.err, "") << call.tool;
    EXPECT_TRUE (std::filesystem::exists (folder (call.result))) << call.tool;
  }
}

TEST (StandardStreams, WhatCannotBePrintedIsAnError)
{
  const TemporaryFolder folder;
  for (const Call& call : callsOfTools (folder)) {
    const ToolRun full = runTool (
        folder, "{ " + kTools + call.tool + " " + call.arguments + " >/dev/full; }");
    EXPECT_EQ (full.status, 1) << call.tool;
    EXPECT_EQ (full.errorLines(), 1) << full.err;
    EXPECT_THAT (full.err, HasSubstr ("standard output: cannot be written"));
    EXPECT_TRUE (std::filesystem::exists (folder (call.result))) << call.tool;
  }
  EXPECT_EQ (runTool (folder, "{ " + kTools + "evaluate --help >/dev/full; }").status,
             1);
}

TEST (StandardStreams, NoFileTakesThePlaceOfAClosedOne)
{
  const auto openAfterClosing = [] {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      close (stream);
    pcl_msf::tool::keepStandardStreams();
    return open ("/dev/null", O_RDONLY);
  };
  EXPECT_EXIT (std::_Exit (openAfterClosing() > STDERR_FILENO ? 7 : 1),
               ::testing::ExitedWithCode (7),
               "");
}

} // namespace
