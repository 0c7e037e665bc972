// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "worker_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <utility>

namespace pcl_msf::tool {

namespace {

bool
readAll (int file, void* bytes, std::size_t size)
{
  auto* at = static_cast<char*> (bytes);
  while (size > 0) {
    const ssize_t n = read (file, at, size);
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return false;
    at += n;
    size -= static_cast<std::size_t> (n);
  }
  return true;
}

bool
writeAll (int file, const void* bytes, std::size_t size)
{
  const auto* at = static_cast<const char*> (bytes);
  while (size > 0) {
    const ssize_t n = write (file, at, size);
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return false;
    at += n;
    size -= static_cast<std::size_t> (n);
  }
  return true;
}

/** What a worker sends before the text. */
struct Header {
  std::uint64_t failed;
  std::uint64_t size;
};

[[noreturn]] void
work (int requests, int answers, const WorkTask& task)
{
  std::uint64_t item = 0;
  while (readAll (requests, &item, sizeof item)) {
    const WorkResult result = attempt (task, item);
    const Header header{result.failed ? 1U : 0U, result.text.size()};
    if (!writeAll (answers, &header, sizeof header) ||
        !writeAll (answers, result.text.data(), result.text.size()))
      break;
  }
  _exit (0);
}

std::string
deathText (int status)
{
  if (WIFSIGNALED (status))
    return "the process was ended by signal " + std::to_string (WTERMSIG (status)) +
           (WTERMSIG (status) == SIGKILL ? " (out of memory? give fewer --jobs)" : "");
  return "the process ended with status " + std::to_string (WEXITSTATUS (status));
}

} // namespace

WorkResult
attempt (const WorkTask& task, std::size_t item)
{
  try {
    return {item, false, task (item)};
  }
  catch (const std::exception& e) {
    return {item, true, e.what()};
  }
}

Worker::Worker (const WorkTask& task, const std::vector<Worker>& others)
{
  int to[2], from[2];
  if (pipe (to) != 0 || pipe (from) != 0)
    throw std::runtime_error ("--jobs: no pipe can be made; give fewer jobs");
  std::fflush (nullptr);
  process_ = fork();
  if (process_ < 0)
    throw std::runtime_error ("--jobs: no process can be started; give fewer jobs");
  if (process_ == 0) {
    for (const Worker& other : others) {
      close (other.requests_);
      close (other.answers_);
    }
    close (to[1]);
    close (from[0]);
    work (to[0], from[1], task);
  }
  close (to[0]);
  close (from[1]);
  requests_ = to[1];
  answers_ = from[0];
}

void
Worker::give (std::size_t item)
{
  item_ = item;
  busy_ = true;
  const std::uint64_t number = item;
  writeAll (requests_, &number, sizeof number); // a dead one is noticed by its answer
}

WorkResult
Worker::take (bool& alive)
{
  busy_ = false;
  Header header{};
  WorkResult result{item_, true, {}};
  alive = readAll (answers_, &header, sizeof header);
  if (alive) {
    result.failed = header.failed != 0;
    result.text.resize (header.size);
    alive = readAll (answers_, result.text.data(), header.size);
  }
  return result;
}

std::string
Worker::end()
{
  close (std::exchange (requests_, -1));
  close (std::exchange (answers_, -1));
  int status = 0;
  while (waitpid (process_, &status, 0) < 0 && errno == EINTR) {
  }
  return deathText (status);
}

} // namespace pcl_msf::tool
