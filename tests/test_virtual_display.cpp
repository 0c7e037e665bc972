// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <pcl_msf/visualization/virtual_display.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

namespace {

using namespace pcl_msf::visualization;

/** Sets an environment variable for one test; null = unset. */
class Environment {
public:
  Environment (const char* name, const char* value) : name_ (name)
  {
    const char* before = std::getenv (name);
    had_ = before != nullptr;
    before_ = had_ ? before : "";
    if (value == nullptr)
      unsetenv (name);
    else
      setenv (name, value, 1);
  }
  ~Environment()
  {
    if (had_)
      setenv (name_, before_.c_str(), 1);
    else
      unsetenv (name_);
  }
  Environment (const Environment&) = delete;
  Environment&
  operator= (const Environment&) = delete;

private:
  const char* name_;
  bool had_;
  std::string before_;
};

/** The socket that a display's server listens on. */
std::string
socketOf (const std::string& display)
{
  return "/tmp/.X11-unix/X" + display.substr (1);
}

bool
goesAway (const std::string& path)
{
  for (int i = 0; i < 1000 && std::filesystem::exists (path); ++i)
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
  return !std::filesystem::exists (path);
}

TEST (VirtualDisplay, StartsOneAndTakesItAway)
{
  const Environment none ("DISPLAY", nullptr);
  EXPECT_THAT (displayProblem(), ::testing::HasSubstr ("DISPLAY is not set"));
  std::string name;
  {
    const VirtualDisplay display;
    EXPECT_TRUE (display.started());
    name = display.name();
    ASSERT_EQ (name.substr (0, 1), ":");
    EXPECT_EQ (displayProblem(), "");
    EXPECT_TRUE (std::filesystem::exists (socketOf (name)));
    const VirtualDisplay inner;
    EXPECT_FALSE (inner.started()) << "there is one already";
    EXPECT_EQ (inner.name(), name);
  }
  EXPECT_EQ (std::getenv ("DISPLAY"), nullptr) << "restored";
  EXPECT_FALSE (std::filesystem::exists (socketOf (name))) << "ended before the guard";
}

TEST (VirtualDisplay, ReplacesADisplayThatDoesNotAnswer)
{
  const Environment stale ("DISPLAY", ":59173");
  EXPECT_THAT (displayProblem(), ::testing::HasSubstr (":59173 cannot be opened"));
  {
    const VirtualDisplay display;
    EXPECT_TRUE (display.started());
    EXPECT_NE (display.name(), ":59173");
  }
  EXPECT_STREQ (std::getenv ("DISPLAY"), ":59173");
}

TEST (VirtualDisplay, SaysWhatToInstall)
{
  const Environment none ("DISPLAY", nullptr);
  const Environment nowhere ("PATH", "/nonexistent");
  try {
    const VirtualDisplay display;
    FAIL() << "a display without Xvfb";
  }
  catch (const DisplayError& e) {
    EXPECT_THAT (e.what(), ::testing::HasSubstr ("sudo apt-get install xvfb"));
    EXPECT_THAT (e.what(), ::testing::Not (::testing::HasSubstr ("\n")));
  }
  EXPECT_EQ (std::getenv ("DISPLAY"), nullptr);
}

/** Whatever ends the process, its display ends, too: also what no handler can see. */
TEST (VirtualDisplay, EndsWithAProcessThatIsKilled)
{
  int ends[2];
  ASSERT_EQ (pipe (ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    unsetenv ("DISPLAY");
    const VirtualDisplay display;
    const std::string name = display.name() + "\n";
    if (write (ends[1], name.data(), name.size()) < 0)
      _exit (1);
    pause();
    _exit (0);
  }
  close (ends[1]);
  std::string name;
  for (char c = 0; read (ends[0], &c, 1) == 1 && c != '\n';)
    name += c;
  close (ends[0]);
  ASSERT_FALSE (name.empty());
  EXPECT_TRUE (std::filesystem::exists (socketOf (name)));
  kill (child, SIGKILL);
  waitpid (child, nullptr, 0);
  EXPECT_TRUE (goesAway (socketOf (name)));
}

} // namespace
