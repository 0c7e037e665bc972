// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/render_case.h"
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

namespace fs = std::filesystem;

/** First word of a file of /proc that is about a process. */
std::string
processName (const fs::path& process)
{
  std::string name = readFile ((process / "comm").string());
  return name.substr (0, name.find ('\n'));
}

/** Process ids of a process's children. */
std::vector<std::string>
childrenOf (const std::string& parent)
{
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator ("/proc")) {
    const std::string status = readFile ((entry.path() / "status").string());
    if (status.find ("\nPPid:\t" + parent + "\n") != std::string::npos)
      found.push_back (entry.path().filename().string());
  }
  return found;
}

/** Waits for a condition as long as a child runs. */
bool
waitFor (const std::function<bool()>& condition, pid_t child)
{
  while (!condition()) {
    if (waitpid (child, nullptr, WNOHANG) != 0)
      return false;
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
  }
  return true;
}

class RenderSignals : public RenderCase, public ::testing::WithParamInterface<int> {};

INSTANTIATE_TEST_SUITE_P (All, RenderSignals, ::testing::Values (SIGTERM, SIGHUP));

TEST_P (RenderSignals, LeaveNoDisplayAndNoHalfPicture)
{
  writeResult();
  const pid_t tool = fork();
  if (tool == 0) {
    unsetenv ("DISPLAY");
    execl (tool_.c_str(),
           tool_.c_str(),
           folder_ ("result").c_str(),
           "--quiet",
           "--animation",
           "warp",
           "--pictures",
           "2000",
           "--size",
           "1280x960",
           "--output",
           folder_ ("out").c_str(),
           nullptr);
    _exit (127);
  }
  ASSERT_TRUE (waitFor (
      [this] { return fs::exists (folder_ ("out/warp/warp_0002.png")); }, tool));
  std::string display;
  for (const std::string& child : childrenOf (std::to_string (tool)))
    if (processName ("/proc/" + child) == "Xvfb")
      display = child;
  ASSERT_FALSE (display.empty()) << "no Xvfb while drawing";
  kill (tool, GetParam());
  int status = 0;
  waitpid (tool, &status, 0);
  ASSERT_TRUE (WIFEXITED (status));
  EXPECT_EQ (WEXITSTATUS (status), 128 + GetParam());
  EXPECT_FALSE (fs::exists ("/proc/" + display) &&
                processName ("/proc/" + display) == "Xvfb");
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator (folder_ ("out/warp"))) {
    EXPECT_EQ (entry.path().extension(), ".png") << entry.path();
    EXPECT_FALSE (cv::imread (entry.path().string()).empty()) << entry.path();
    ++pictures;
  }
  EXPECT_LT (pictures, 2000);
}

} // namespace
