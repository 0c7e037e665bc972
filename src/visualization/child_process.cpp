// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace pcl_msf::visualization {

namespace {

constexpr double kPatience = 2.0; ///< seconds between SIGTERM and SIGKILL
constexpr int kNotStarted = 127;  ///< exit status as shells have it

/** In the child: only calls that are safe between fork and exec. */
[[noreturn]] void
become (const char* program, char* const* arguments, pid_t parent, int inherited)
{
  setpgid (0, 0);
  prctl (PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent)
    _exit (kNotStarted);
  sigset_t none;
  sigemptyset (&none);
  sigprocmask (SIG_SETMASK, &none, nullptr);
  const int nothing = open ("/dev/null", O_RDWR);
  dup2 (nothing, STDIN_FILENO);
  dup2 (nothing, STDOUT_FILENO);
  dup2 (nothing, STDERR_FILENO);
  if (inherited >= 0)
    fcntl (inherited, F_SETFD, 0);
  execv (program, arguments);
  _exit (kNotStarted);
}

} // namespace

std::string
findProgram (const std::string& name)
{
  const char* path = std::getenv ("PATH");
  std::istringstream folders (path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline (folders, folder, ':');) {
    const std::string file = (std::filesystem::path (folder) / name).string();
    std::error_code ignored;
    if (std::filesystem::is_regular_file (file, ignored) &&
        access (file.c_str(), X_OK) == 0)
      return file;
  }
  return {};
}

ChildProcess::ChildProcess (const std::vector<std::string>& arguments, int inherited)
{
  std::vector<char*> pointers;
  for (const std::string& argument : arguments)
    pointers.push_back (const_cast<char*> (argument.c_str()));
  pointers.push_back (nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0)
    become (pointers[0], pointers.data(), parent, inherited);
  if (pid_ < 0)
    throw std::runtime_error (arguments.at (0) + ": cannot be started");
}

ChildProcess::~ChildProcess()
{
  if (exitStatus())
    return;
  kill (pid_, SIGTERM);
  if (!wait (kPatience)) {
    kill (pid_, SIGKILL);
    while (waitpid (pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

std::optional<int>
ChildProcess::exitStatus()
{
  int code = 0;
  if (!status_ && waitpid (pid_, &code, WNOHANG) == pid_)
    status_ = WIFEXITED (code) ? WEXITSTATUS (code) : 128 + WTERMSIG (code);
  return status_;
}

std::optional<int>
ChildProcess::wait (double seconds, const std::function<bool()>& cancelled)
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double> (seconds);
  while (!exitStatus() && Clock::now() < end && !(cancelled && cancelled()))
    std::this_thread::sleep_for (std::chrono::milliseconds (5));
  return status_;
}

} // namespace pcl_msf::visualization
