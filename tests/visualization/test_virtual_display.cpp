// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "visualization/child_process.h"
#include <gmock/gmock.h>
#include <pcl_msf/visualization/virtual_display.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <X11/Xlib.h>

#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

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

/** The socket that a display's server listens on. The number of a display that has
 * ended may be another server's at once, so a server is known by its socket. */
class Socket {
public:
  explicit Socket (const std::string& display)
  : path_ ("/tmp/.X11-unix/X" + display.substr (1)), there_ (look (at_begin_))
  {}

  /** Is the socket that was there at the beginning still there? */
  bool
  exists () const
  {
    struct stat now = {};
    return there_ && look (now) && now.st_dev == at_begin_.st_dev &&
           now.st_ino == at_begin_.st_ino &&
           now.st_ctim.tv_sec == at_begin_.st_ctim.tv_sec &&
           now.st_ctim.tv_nsec == at_begin_.st_ctim.tv_nsec;
  }
  /** Waits as long as the test may take. */
  void
  waitUntilGone () const
  {
    while (exists())
      std::this_thread::sleep_for (std::chrono::milliseconds (10));
  }

private:
  bool
  look (struct stat& found) const
  {
    return stat (path_.c_str(), &found) == 0;
  }

  std::string path_;
  struct stat at_begin_ = {};
  bool there_;
};

TEST (VirtualDisplay, StartsOneAndTakesItAway)
{
  const Environment none ("DISPLAY", nullptr);
  EXPECT_THAT (displayProblem(), ::testing::HasSubstr ("DISPLAY is not set"));
  std::unique_ptr<Socket> socket;
  {
    const VirtualDisplay display;
    EXPECT_TRUE (display.started());
    const std::string name = display.name();
    ASSERT_EQ (name.substr (0, 1), ":");
    EXPECT_EQ (displayProblem(), "");
    socket = std::make_unique<Socket> (name);
    EXPECT_TRUE (socket->exists());
    const VirtualDisplay inner;
    EXPECT_FALSE (inner.started()) << "there is one already";
    EXPECT_EQ (inner.name(), name);
  }
  EXPECT_EQ (std::getenv ("DISPLAY"), nullptr) << "restored";
  EXPECT_FALSE (socket->exists()) << "ended before the guard";
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

/** An Xvfb as users start it: when its last client leaves, it starts anew. */
class ForgetfulDisplay {
public:
  ForgetfulDisplay()
  {
    int ends[2];
    if (pipe (ends) != 0)
      return;
    server_ = std::make_unique<ChildProcess> (
        std::vector<std::string>{
            findProgram ("Xvfb"), "-displayfd", std::to_string (ends[1])},
        ends[1]);
    close (ends[1]);
    for (char c = 0; read (ends[0], &c, 1) == 1 && c != '\n';)
      name_ += c;
    close (ends[0]);
  }
  std::string
  name () const
  {
    return ":" + name_;
  }
  /** Is there an atom of that name? A server that starts anew has none. */
  bool
  remembers (const char* atom) const
  {
    return intern (atom, True) != None;
  }
  Atom
  intern (const char* atom, Bool only_known) const
  {
    Display* display = XOpenDisplay (name().c_str());
    const Atom found = display != nullptr ? XInternAtom (display, atom, only_known) : 0;
    if (display != nullptr)
      XCloseDisplay (display);
    return found;
  }

private:
  std::unique_ptr<ChildProcess> server_;
  std::string name_;
};

TEST (VirtualDisplay, HoldsADisplayThatWasThere)
{
  const ForgetfulDisplay server;
  ASSERT_NE (server.name(), ":");
  const Environment there ("DISPLAY", server.name().c_str());
  const VirtualDisplay display;
  EXPECT_FALSE (display.started());
  server.intern ("PCL_MSF_TEST", False);
  EXPECT_TRUE (server.remembers ("PCL_MSF_TEST")) << "the guard is a client";
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
    EXPECT_THAT (e.what(), ::testing::HasSubstr ("install it (Debian: xvfb)"));
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
  const Socket socket (name);
  EXPECT_TRUE (socket.exists());
  kill (child, SIGKILL);
  waitpid (child, nullptr, 0);
  socket.waitUntilGone();
}

} // namespace
