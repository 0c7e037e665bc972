// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Several targets of pcl_msf_register, as a user runs it.
#include <gtest/gtest.h>

#include "support/box_chain.h"
#include "support/expect_refusal.h"
#include "support/run_tool.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/point_files.h>

#include <filesystem>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

/** A chain that turns on, in two targets. */
class RegisterWindow : public ::testing::Test {
protected:
  RegisterWindow()
  {
    turned_.angle = 2.0 * chain_.angle;
    source_ = drawChain (chain_, 2500, false, 1);
    const ChainCloud first = drawChain (chain_, 2500, true, 2);
    const ChainCloud second = drawChain (turned_, 2500, true, 3);
    io::writePointsPly (folder_ ("source.ply"), source_.points);
    io::writePointsPly (folder_ ("first.ply"), first.points);
    io::writePointsPly (folder_ ("second.ply"), second.points);
  }
  ToolRun
  run (const std::string& files, const std::string& options) const
  {
    std::string command = PCL_MSF_TOOLS "/pcl_msf_register";
    std::istringstream words (files);
    for (std::string word; words >> word;)
      command += " " + folder_ (word + ".ply");
    return runTool (folder_, command + " " + options + " --output " + folder_ ("out"));
  }
  double
  meanError (const std::string& file, const BoxChain& moved) const
  {
    const auto warped = io::readPoints (folder_ ("out/" + file)).points;
    double sum = 0.0;
    for (std::size_t i = 0; i < warped.size(); ++i)
      sum += (warped[i].cast<double>() -
              moved.pose (source_.box[i]) * source_.rest[i].cast<double>())
                 .norm();
    return sum / static_cast<double> (source_.points.size());
  }
  bool
  exists (const std::string& file) const
  {
    return std::filesystem::exists (folder_ ("out/" + file));
  }

  TemporaryFolder folder_;
  BoxChain chain_;
  BoxChain turned_;
  ChainCloud source_;
};

TEST_F (RegisterWindow, EachTargetHasItsFiles)
{
  const ToolRun done = run ("source first second", "--threads 2");
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_THAT (done.out, HasSubstr ("target 2: 2500 points"));
  EXPECT_LT (meanError ("warped_0_1.ply", chain_), 3e-3);
  EXPECT_LT (meanError ("warped_0_2.ply", turned_), 5e-3);
  EXPECT_EQ (io::readRegisteredCloud (folder_ ("out/registered_0_1.pcd")).part,
             io::readRegisteredCloud (folder_ ("out/registered_0_2.pcd")).part);
  EXPECT_EQ (io::readJoints (folder_ ("out/joints_0_1.json")).size(),
             io::readJoints (folder_ ("out/joints_0_2.json")).size());
  for (const char* report : {"report_0_1.json", "report_0_2.json", "report.json"})
    EXPECT_THAT (readFile (folder_ (std::string ("out/") + report)),
                 HasSubstr ("\"converged\": true"));
  EXPECT_TRUE (exists ("parts_0.txt"));
  EXPECT_EQ (filesIn (folder_ ("out")), 11u); // with the list of them
}

TEST_F (RegisterWindow, OneTargetReplacesSeveral)
{
  ASSERT_EQ (run ("source first second", "--quiet").status, 0);
  const ToolRun done = run ("source first", "--quiet");
  ASSERT_EQ (done.status, 0) << done.err;
  EXPECT_TRUE (exists ("warped.ply"));
  EXPECT_FALSE (exists ("warped_0_1.ply"));
  EXPECT_EQ (filesIn (folder_ ("out")), 6u);
}

TEST_F (RegisterWindow, PairsNameTheirTarget)
{
  writeFile (folder_ ("pairs.txt"), "0 5 1 2\n1 7\n");
  const std::string pairs = " --quiet --pairs " + folder_ ("pairs.txt");
  expectRefusal (run ("source first", pairs),
                 "one target",
                 {"pairs.txt: line 1: K is 2, and there is 1 target, counted from 1"});
  writeFile (folder_ ("pairs.txt"), "0 5 1 0\n");
  expectRefusal (run ("source first second", pairs), "target 0", {"line 1"});
  expectRefusal (run ("source first second", "--concatenation-weight -1"),
                 "weight",
                 {"--concatenation-weight"});
}

TEST_F (RegisterWindow, FaultsOfConstraintsNameTheirLine)
{
  const std::string pairs = folder_ ("pairs.txt"), labels = folder_ ("labels.txt");
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"0 1\n2500 1\n", "line 2: SOURCE is 2500; the source has 2500 points"},
      {"# none\n0 -1\n", "line 2: TARGET is -1; the target 1 has 2500 points"},
      {"0 9999 1 2\n", "line 1: TARGET is 9999; the target 2 has 2500 points"},
      {"0 1 0\n", "line 1: WEIGHT is 0, must be greater than 0"},
      {"0 1 1 3\n", "line 1: K is 3, and there are 2 targets, counted from 1"}};
  for (const auto& [text, words] : wrong) {
    writeFile (pairs, text);
    expectRefusal (run ("source first second", " --quiet --pairs " + pairs),
                   text,
                   {"pairs.txt: " + words});
  }
  const auto refused = [&] (const std::string& text, const std::string& words) {
    writeFile (labels, text);
    expectRefusal (run ("source first", " --quiet --segments " + labels),
                   words,
                   {"labels.txt: " + words});
  };
  refused ("1\n2\n", "line 2: the file ends after 2 labels, the source has 2500");
  std::string all;
  for (int i = 0; i < 2500; ++i)
    all += "-1\n";
  refused (all + "7\n", "line 2501: one label too many, the source has 2500");
  refused (all, "labels: all are negative");
}

TEST_F (RegisterWindow, AByteOrderMarkIsNoNumber)
{
  writeFile (folder_ ("pairs.txt"),
             "\xEF\xBB\xBF"
             "0 2500 1\r\n");
  expectRefusal (run ("source first", " --quiet --pairs " + folder_ ("pairs.txt")),
                 "mark",
                 {"line 1: TARGET is 2500"});
}

TEST_F (RegisterWindow, ALostTargetIsTheVerdict)
{
  BoxChain other; // something else
  other.boxes = 1;
  other.size = {0.05, 1.1, 0.05};
  io::writePointsPly (folder_ ("other.ply"), drawChain (other, 800, true, 4).points);
  const ToolRun done = run ("source first other", "--quiet");
  EXPECT_EQ (done.status, 3);
  EXPECT_THAT (done.err, HasSubstr ("target 2: "));
  EXPECT_THAT (readFile (folder_ ("out/report.json")),
               HasSubstr ("\"converged\": false"));
  EXPECT_THAT (readFile (folder_ ("out/report_0_1.json")),
               HasSubstr ("\"converged\": true"));
}

} // namespace
