// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "worker_pool.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <utility>

namespace pcl_msf::tool {

namespace {

using Task = std::function<std::string (std::size_t)>;

WorkResult
attempt (const Task& task, std::size_t item)
{
  try {
    return {item, false, task (item)};
  }
  catch (const std::exception& e) {
    return {item, true, e.what()};
  }
}

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
work (int requests, int answers, const Task& task)
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

/** One process and the pipes to it. */
class Worker {
public:
  /** \param others whose pipes the new process must not hold open */
  Worker (const Task& task, const std::vector<Worker>& others);

  bool
  busy () const
  {
    return busy_;
  }
  int
  answers () const
  {
    return answers_;
  }
  void
  give (std::size_t item);

  /** The result of the present item; sets alive to false when the process is dead. */
  WorkResult
  take (bool& alive);

  /** Ends the process after its present item and waits for it. \return wait's status */
  int
  end ();

private:
  pid_t process_;
  int requests_;
  int answers_;
  std::size_t item_{0};
  bool busy_{false};
};

Worker::Worker (const Task& task, const std::vector<Worker>& others)
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

int
Worker::end()
{
  close (std::exchange (requests_, -1));
  close (std::exchange (answers_, -1));
  int status = 0;
  while (waitpid (process_, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string
deathText (int status)
{
  if (WIFSIGNALED (status))
    return "the process was ended by signal " + std::to_string (WTERMSIG (status)) +
           (WTERMSIG (status) == SIGKILL ? " (out of memory? give fewer --jobs)" : "");
  return "the process ended with status " + std::to_string (WEXITSTATUS (status));
}

/** Workers and what is left to do. */
class Pool {
public:
  Pool (int jobs, std::vector<std::size_t> items, const Task& task)
  : items_ (std::move (items)), task_ (task)
  {
    const auto useful = std::min (static_cast<std::size_t> (jobs), items_.size());
    workers_.reserve (useful);
    while (workers_.size() < useful)
      workers_.emplace_back (task_, workers_);
  }
  Pool (const Pool&) = delete;
  Pool&
  operator= (const Pool&) = delete;
  ~Pool()
  {
    for (Worker& worker : workers_)
      worker.end();
  }

  void
  run (const std::function<bool (const WorkResult&)>& done)
  {
    bool go_on = true;
    while (handOut (go_on))
      for (Worker* worker : waitForAnswers())
        go_on = done (collect (*worker)) && go_on;
  }

private:
  /** Gives every idle worker an item. \return is any at work? */
  bool
  handOut (bool go_on)
  {
    bool any = false;
    for (Worker& worker : workers_) {
      if (!worker.busy() && go_on && next_ < items_.size())
        worker.give (items_[next_++]);
      any = any || worker.busy();
    }
    return any;
  }

  std::vector<Worker*>
  waitForAnswers ()
  {
    std::vector<pollfd> files;
    for (const Worker& worker : workers_)
      files.push_back ({worker.busy() ? worker.answers() : -1, POLLIN, 0});
    while (poll (files.data(), files.size(), -1) < 0 && errno == EINTR) {
    }
    std::vector<Worker*> ready;
    for (std::size_t i = 0; i < files.size(); ++i)
      if (files[i].revents != 0)
        ready.push_back (&workers_[i]);
    return ready;
  }

  /** A worker's result; one that has died is replaced. */
  WorkResult
  collect (Worker& worker)
  {
    bool alive = true;
    WorkResult result = worker.take (alive);
    if (!alive) {
      result = {result.item, true, deathText (worker.end())};
      worker = Worker (task_, workers_);
    }
    return result;
  }

  std::vector<std::size_t> items_;
  std::size_t next_{0};
  const Task& task_;
  std::vector<Worker> workers_;
};

/** While it lives, writing to a dead worker is no reason to die. */
class IgnorePipeSignal {
public:
  IgnorePipeSignal() : before_ (std::signal (SIGPIPE, SIG_IGN)) {}
  ~IgnorePipeSignal() { std::signal (SIGPIPE, before_); }
  IgnorePipeSignal (const IgnorePipeSignal&) = delete;
  IgnorePipeSignal&
  operator= (const IgnorePipeSignal&) = delete;

private:
  void (*before_) (int);
};

} // namespace

void
runInProcesses (int jobs,
                const std::vector<std::size_t>& items,
                const std::function<std::string (std::size_t)>& task,
                const std::function<bool (const WorkResult&)>& done)
{
  if (jobs > 1) {
    const IgnorePipeSignal ignore;
    Pool (jobs, items, task).run (done);
    return;
  }
  for (const std::size_t item : items)
    if (!done (attempt (task, item)))
      return;
}

} // namespace pcl_msf::tool
