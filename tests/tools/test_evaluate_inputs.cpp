// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "evaluate/pair_table.h"
#include "support/run_tool.h"
#include <gmock/gmock.h>

#include <filesystem>
#include <string>

// Recordings that pcl_msf_evaluate meets.

namespace {

using namespace pcl_msf::testing;
using ::testing::HasSubstr;

class EvaluateInputs : public ::testing::Test {
protected:
  ToolRun
  run (const std::string& arguments) const
  {
    return runTool (folder_, PCL_MSF_TOOLS "/pcl_msf_evaluate" + arguments);
  }
  void
  writeCase (const std::string& name, int frames) const
  {
    const ToolRun written = runTool (
        folder_,
        PCL_MSF_TOOLS "/pcl_msf_synthesize '" + folder_ (name) +
            "' --width 64 --height 48 --depth png --frames " + std::to_string (frames));
    EXPECT_EQ (written.status, 0) << written.err;
  }

  TemporaryFolder folder_;
};

TEST_F (EvaluateInputs, ARunGoesOnWhateverItsCasesAreCalled)
{
  const std::string plain = "cases/two lines, \"a\" ",
                    odd = "cases/two\nlines, \"a\"\r";
  writeCase (plain, 2);
  std::filesystem::copy (
      folder_ (plain), folder_ (odd), std::filesystem::copy_options::recursive);
  const std::string what = " cases " + folder_ ("cases") +
                           " --methods zero --quiet --csv " + folder_ ("a.csv");
  ASSERT_EQ (run (what).status, 0);
  const std::string before = readFile (folder_ ("a.csv"));
  const ToolRun again = run (what);
  EXPECT_EQ (again.status, 0) << again.err;
  EXPECT_EQ (readFile (folder_ ("a.csv")), before) << "nothing was done again";
  const auto file = pcl_msf::tool::readResults (folder_ ("a.csv"));
  ASSERT_EQ (file.rows.size(), 2U);
  EXPECT_NE (file.rows[0].sequence, file.rows[1].sequence);
}

TEST_F (EvaluateInputs, TellsOnceThatDepthCanHardlyBeInMetres)
{
  writeCase ("case", 3);
  const std::string camera = readFile (folder_ ("case/camera.txt"));
  writeFile (folder_ ("case/camera.txt"), // its depth is in 1/5000 m
             camera.substr (0, camera.rfind (' ')) + " 50\n");
  const std::string what = " cases " + folder_ ("case") + " --methods zero --quiet";
  const ToolRun told = run (what);
  EXPECT_EQ (told.status, 0);
  EXPECT_EQ (told.errorLines(), 1) << told.err;
  for (const char* word : {"case: frame 0: depth is ", "give --depth-scale"})
    EXPECT_THAT (told.err, HasSubstr (word));
  EXPECT_EQ (run (what + " --depth-scale 5000").err, "");
}

} // namespace
