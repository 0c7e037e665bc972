// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/command_line.h"
#include "common/interruption.h"
#include "common/option_values.h"
#include "common/tool_main.h"
#include <gmock/gmock.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using ::testing::ElementsAre;

struct Given {
  int count{0};
  std::string name;
  bool help{false};
  std::vector<std::string> words;
};

Given
read (std::vector<const char*> words)
{
  words.insert (words.begin(), "tool");
  Given given;
  const std::vector<OptionGroup> groups = {
      {"Numbers", {{"--count", "N", "how many [0]", number (given.count)}}},
      {"Others",
       {{"--name", "TEXT", "whose [nobody's]", text (given.name)},
        {"--help", "", "print this", flag (given.help)}}}};
  readCommandLine (
      static_cast<int> (words.size()),
      words.data(),
      groups,
      [&given] (const std::string& word) { given.words.push_back (word); });
  return given;
}

std::string
refusal (const std::vector<const char*>& words)
{
  try {
    read (words);
  }
  catch (const UsageError& e) {
    return e.what();
  }
  return "taken";
}

TEST (CommandLine, ReadsOptionsOfAllGroupsAndWords)
{
  const Given given = read ({"first", "--count", "-3", "--name=a=b", "", "-h"});
  EXPECT_EQ (given.count, -3);
  EXPECT_EQ (given.name, "a=b");
  EXPECT_TRUE (given.help);
  EXPECT_THAT (given.words, ElementsAre ("first", ""));
}

TEST (CommandLine, SaysWhatItRefuses)
{
  EXPECT_EQ (refusal ({"--cuont", "3"}), "--cuont: no such option; --help lists them");
  EXPECT_EQ (refusal ({"--count"}), "--count: needs a value, N");
  EXPECT_EQ (refusal ({"--count", "x"}), "--count: 'x' is no N; how many [0]");
  EXPECT_EQ (refusal ({"--count=3.5"}), "--count: '3.5' is no N; how many [0]");
  EXPECT_EQ (refusal ({"--name="}), "--name: '' is no TEXT; whose [nobody's]");
  EXPECT_EQ (refusal ({"--help=1"}), "--help: takes no value");
}

TEST (CommandLine, ListsAreReadAsAWhole)
{
  int size[2] = {};
  EXPECT_TRUE (parseList ("640x480", 'x', size));
  EXPECT_THAT (size, ElementsAre (640, 480));
  for (const char* bad :
       {"", "640", "640x", "x480", "640x480x2", "640x480x", "640 x480"})
    EXPECT_FALSE (parseList (bad, 'x', size)) << bad;
}

struct NoOptions {
  bool help{false};
};

/** Exit status of a tool with one argument that runs so. */
int
statusOf (int (*run) (const NoOptions&))
{
  const auto parse = [] (int, const char* const*) { return NoOptions{}; };
  const char* const line[] = {"tool", "word"};
  return toolMain<NoOptions> ({"tool", parse, [] (const char*) {}, run}, 2, line);
}

TEST (ToolMain, ErrorsAreOneLineAndAStatus)
{
  EXPECT_EQ (statusOf ([] (const NoOptions&) { return 7; }), 7);
  ::testing::internal::CaptureStderr();
  const int status =
      statusOf ([] (const NoOptions&) -> int { throw UsageError ("two\nlines"); });
  EXPECT_EQ (::testing::internal::GetCapturedStderr(), "tool: two lines\n");
  EXPECT_EQ (status, 1);
}

TEST (ToolMain, HelpIsNoRun)
{
  const auto parse = [] (int, const char* const*) { return NoOptions{true}; };
  const auto print = [] (const char* program) { std::printf ("of %s\n", program); };
  const auto run = [] (const NoOptions&) { return 7; };
  const char* const line[] = {"tool", "--help"};
  ::testing::internal::CaptureStdout();
  EXPECT_EQ (toolMain<NoOptions> ({"tool", parse, print, run}, 1, line), 1);
  EXPECT_EQ (toolMain<NoOptions> ({"tool", parse, print, run}, 2, line), 0);
  EXPECT_EQ (::testing::internal::GetCapturedStdout(), "of tool\nof tool\n");
}

TEST (ToolMain, ASignalEndsWithItsStatus)
{
  const auto interrupted_run = [] (const NoOptions&) {
    std::raise (SIGTERM);
    throwIfInterrupted();
    return 7;
  };
  EXPECT_EXIT (std::_Exit (statusOf (interrupted_run)),
               ::testing::ExitedWithCode (128 + SIGTERM),
               "tool: interrupted; not everything is written");
}

} // namespace
