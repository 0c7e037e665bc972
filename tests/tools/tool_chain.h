// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include "support/expect_refusal.h"
#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace pcl_msf::testing {

/** \brief All tools one after the other, as a user runs them, in a folder of their own.
 */
class ToolChain : public ::testing::Test {
protected:
  static std::string
  tools ()
  {
    return PCL_MSF_TOOLS;
  }
  ToolRun
  run (const std::string& tool, const std::string& arguments) const
  {
    return runTool (folder_,
                    "env -u DISPLAY " + tools() + "/pcl_msf_" + tool + " " + arguments);
  }
  void
  expectSuccess (const std::string& tool, const std::string& arguments) const
  {
    const ToolRun done = run (tool, arguments);
    EXPECT_EQ (done.status, 0) << tool << " " << arguments << "\n" << done.err;
  }
  void
  expectRefusal (const std::string& tool,
                 const std::string& arguments,
                 const std::vector<std::string>& words) const
  {
    testing::expectRefusal (run (tool, arguments), tool + " " + arguments, words);
  }
  void
  synthesize (const std::string& name, int frames, const std::string& more = {}) const
  {
    expectSuccess ("synthesize",
                   folder_ (name) + " --width 160 --height 120 --depth png --frames " +
                       std::to_string (frames) + more);
  }
  static bool
  hasTool (const std::string& name)
  {
    return std::filesystem::exists (tools() + "/pcl_msf_" + name);
  }

  /** Report, renders and the live window of a result. \param pair as in its names */
  void
  showResult (const std::string& result, const std::string& pair) const
  {
    expectSuccess ("report", result + " --output " + result + "/index.html");
    const std::string page = readFile (result + "/index.html");
    for (const char* kind : {"flow", "residual", "overlay", "occlusion"})
      EXPECT_THAT (page, ::testing::HasSubstr ("src=\"" + (kind + pair) + ".png\""));
    EXPECT_THAT (page, ::testing::HasSubstr ("<th>stop reason</th>"));
    if (!hasTool ("render"))
      return;
    expectSuccess ("render",
                   result + " --sequence " + folder_ ("seq") +
                       " --quiet --kind after_tints --output " + result);
    EXPECT_TRUE (std::filesystem::exists (result + "/after_tints.png"));
    expectSuccess ("report", result + " --output " + result + "/index.html");
    EXPECT_THAT (readFile (result + "/index.html"),
                 ::testing::HasSubstr ("\"after_tints.png\""));
    watch (result + " --sequence " + folder_ ("seq"));
  }

  /** A live window on a display of its own, until it is told to end. */
  void
  watch (const std::string& arguments) const
  {
    const std::string display = folder_ ("display");
    std::filesystem::remove (display);
    const ToolRun seen =
        runTool (folder_,
                 "{ Xvfb -displayfd 3 -screen 0 640x480x24 -nolisten tcp 3>" + display +
                     " 2>/dev/null & x=$!; until [ -s " + display +
                     " ]; do sleep 0.05; done; DISPLAY=:$(cat " + display +
                     ") timeout --preserve-status 4 " + tools() + "/pcl_msf_view " +
                     arguments + "; s=$?; kill $x; wait $x; exit $s; }");
    EXPECT_EQ (seen.status, 128 + 15) << "it was open until it was told to end";
    EXPECT_EQ (seen.err, "");
  }

  TemporaryFolder folder_;
};

} // namespace pcl_msf::testing
