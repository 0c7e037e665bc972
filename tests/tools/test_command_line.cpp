// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/command_line.h"
#include "common/interruption.h"
#include "common/tool_main.h"
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
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
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Given {
  int count{0};
  std::string name;
  std::string word;
  std::vector<std::string> files;
};

bool
read (Given& given, const std::vector<std::string>& words)
{
  CLI::App app;
  addText (app, "WORD", "TEXT", "any", given.word);
  addNumber (app, "--count", "N", "how many", given.count);
  addText (app, "--name", "TEXT", "whose", given.name);
  addTexts (app, "--file", "FILE", "which", given.files);
  return readCommandLine (app, words);
}

std::string
refusal (const std::vector<std::string>& words)
{
  try {
    Given given;
    read (given, words);
  }
  catch (const UsageError& e) {
    return e.what();
  }
  return "taken";
}

TEST (CommandLine, ReadsOptionsAndWords)
{
  Given given;
  EXPECT_TRUE (read (given,
                     {"--file",
                      "a",
                      "first",
                      "--count",
                      "7",
                      "--count",
                      "-3",
                      "--name=a=b",
                      "--file=b"}));
  EXPECT_EQ (given.count, -3);
  EXPECT_EQ (given.name, "a=b");
  EXPECT_EQ (given.word, "first");
  EXPECT_THAT (given.files, ElementsAre ("a", "b"));
}

TEST (CommandLine, NumbersAreDecimalAndFinite)
{
  Given given;
  EXPECT_TRUE (read (given, {"--count", "010"}));
  EXPECT_EQ (given.count, 10);
  double number = 0.0;
  for (const char* bad : {"nan", "inf", "1e999", "0,5", "", "1 "})
    EXPECT_FALSE (parse (bad, number)) << bad;
}

TEST (CommandLine, SaysWhatItRefuses)
{
  EXPECT_EQ (refusal ({"--cuont", "3"}), "--cuont: no such option; --help lists them");
  EXPECT_THAT (refusal ({"--count"}), StartsWith ("--count: needs a value"));
  EXPECT_EQ (refusal ({"--count", "x"}), "--count: 'x' is no N; how many");
  EXPECT_EQ (refusal ({"--count=3.5"}), "--count: '3.5' is no N; how many");
  EXPECT_THAT (refusal ({"--name="}), StartsWith ("--name: needs a value"));
  EXPECT_THAT (refusal ({"a", "stray"}), StartsWith ("'stray': one word too many"));
  EXPECT_THAT (refusal ({""}), StartsWith ("WORD: ''"));
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
  std::string word;
  int count{3};
};

/** Exit status of a tool with these words that runs so. */
int
statusOf (int (*run) (const NoOptions&), std::vector<const char*> words = {"word"})
{
  const auto declare = [] (CLI::App& app, NoOptions& options) {
    addText (app, "WORD", "TEXT", "any", options.word);
    addNumber (app, "--count", "N", "how many", options.count);
  };
  words.insert (words.begin(), "tool");
  return toolMain<NoOptions> (
      {"tool", "A tool.", declare, run}, static_cast<int> (words.size()), words.data());
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
  const auto run = [] (const NoOptions&) { return 7; };
  ::testing::internal::CaptureStdout();
  EXPECT_EQ (statusOf (run, {}), 1);
  EXPECT_EQ (statusOf (run, {"--help"}), 0);
  EXPECT_EQ (statusOf (run, {"-h"}), 0);
  const std::string help = ::testing::internal::GetCapturedStdout();
  EXPECT_THAT (help, StartsWith ("A tool."));
  EXPECT_THAT (help, HasSubstr ("--count N [3]"));
}

TEST (ToolMain, WithoutArgumentsItSaysWhatIsMissing)
{
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ (statusOf ([] (const NoOptions&) { return 7; }, {}), 1);
  EXPECT_THAT (::testing::internal::GetCapturedStdout(), StartsWith ("A tool."));
  EXPECT_THAT (::testing::internal::GetCapturedStderr(),
               StartsWith ("tool: arguments: missing"));
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
