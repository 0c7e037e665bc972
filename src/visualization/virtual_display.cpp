// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <vtkRenderingOpenGLConfigure.h>

#include "visualization/child_process.h"
#include <fcntl.h>
#include <pcl_msf/visualization/virtual_display.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace pcl_msf::visualization {

namespace {

#if defined(VTK_USE_X) && !defined(VTK_OPENGL_HAS_EGL)
constexpr bool kNeedsDisplay = true;
#else
constexpr bool kNeedsDisplay = false;
#endif

constexpr int kStartSeconds = 30; ///< a busy machine needs more than a moment

std::string
displayVariable ()
{
  const char* value = std::getenv ("DISPLAY");
  return value == nullptr ? "" : value;
}

/** Both ends of a pipe, closed on exec and at the end. */
class Pipe {
public:
  Pipe()
  {
    if (pipe2 (ends_, O_CLOEXEC) != 0)
      throw DisplayError (std::string ("no pipe to Xvfb: ") + std::strerror (errno));
  }
  ~Pipe()
  {
    close (ends_[0]);
    closeWriter();
  }
  Pipe (const Pipe&) = delete;
  Pipe&
  operator= (const Pipe&) = delete;

  int
  writer () const
  {
    return ends_[1];
  }
  void
  closeWriter ()
  {
    if (ends_[1] >= 0)
      close (ends_[1]);
    ends_[1] = -1;
  }

  /** A line from the other side; empty when it says nothing in time. */
  std::string
  line ()
  {
    std::string text;
    for (int waited = 0; waited < 10 * kStartSeconds;) {
      pollfd wanted{ends_[0], POLLIN, 0};
      if (poll (&wanted, 1, 100) <= 0) {
        ++waited;
        continue;
      }
      char c = 0;
      if (read (ends_[0], &c, 1) != 1)
        return {};
      if (c == '\n')
        return text;
      text += c;
    }
    return {};
  }

private:
  int ends_[2]{-1, -1};
};

} // namespace

/** A running Xvfb, DISPLAY pointing to it. */
class VirtualDisplay::Server {
public:
  explicit Server (const std::string& problem)
  : before_ (displayVariable()), had_variable_ (std::getenv ("DISPLAY") != nullptr)
  {
    const std::string program = findProgram ("Xvfb");
    if (program.empty())
      throw DisplayError (problem +
                          ", and no Xvfb to start one: install it (Debian: xvfb)");
    Pipe pipe;
    child_ = std::make_unique<ChildProcess> (
        std::vector<std::string>{program,
                                 "-displayfd",
                                 std::to_string (pipe.writer()),
                                 "-screen",
                                 "0",
                                 "1280x1024x24",
                                 "-nolisten",
                                 "tcp",
                                 "-noreset"},
        pipe.writer());
    pipe.closeWriter();
    const std::string number = pipe.line();
    if (number.empty())
      throw DisplayError (problem + ", and Xvfb does not start; see what it says: " +
                          program + " -displayfd 1");
    setenv ("DISPLAY", (":" + number).c_str(), 1);
    const std::string remaining = displayProblem();
    if (!remaining.empty()) {
      restore();
      throw DisplayError ("Xvfb runs, but " + remaining);
    }
  }
  ~Server() { restore(); }
  Server (const Server&) = delete;
  Server&
  operator= (const Server&) = delete;

private:
  void
  restore ()
  {
    if (had_variable_)
      setenv ("DISPLAY", before_.c_str(), 1);
    else
      unsetenv ("DISPLAY");
  }

  std::string before_;
  bool had_variable_;
  std::unique_ptr<ChildProcess> child_;
};

VirtualDisplay::VirtualDisplay()
{
  if (!kNeedsDisplay)
    return;
  const std::string problem = displayProblem (&connection_);
  if (!problem.empty())
    server_ = std::make_unique<Server> (problem);
}

VirtualDisplay::~VirtualDisplay() = default;

bool
VirtualDisplay::started() const
{
  return server_ != nullptr;
}

std::string
VirtualDisplay::name() const
{
  return kNeedsDisplay ? displayVariable() : std::string();
}

} // namespace pcl_msf::visualization
