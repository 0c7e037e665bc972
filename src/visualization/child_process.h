// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::visualization {

/** \brief Full path of a program on PATH; empty when there is none. */
std::string
findProgram (const std::string& name);

/** \brief A program that ends at the latest when this object does, or when the thread
 * that started it ends (SIGTERM). In a process group of its own; output discarded. */
class ChildProcess {
public:
  /** \param arguments the program's full path first \param inherited file descriptor
   * that the child keeps; -1 = none \throws std::runtime_error when it cannot start */
  explicit ChildProcess (const std::vector<std::string>& arguments, int inherited = -1);

  /** \brief Ends it: SIGTERM, and SIGKILL after two seconds. */
  ~ChildProcess();
  ChildProcess (const ChildProcess&) = delete;
  ChildProcess&
  operator= (const ChildProcess&) = delete;

  /** \brief Exit status once it has ended; 128 + the signal that ended it. */
  std::optional<int>
  exitStatus ();

  /** \brief Waits for the end, at most so many seconds. \param cancelled asked every
   * few milliseconds; true stops waiting \return as exitStatus */
  std::optional<int>
  wait (double seconds, const std::function<bool()>& cancelled = {});

private:
  pid_t pid_{-1};
  std::optional<int> status_;
};

} // namespace pcl_msf::visualization
