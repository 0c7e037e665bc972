// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "worker_pool.h"

#include "worker_process.h"
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <utility>

namespace pcl_msf::tool {

namespace {

/** Workers and what is left to do. */
class Pool {
public:
  Pool (int jobs, std::vector<std::size_t> items, const WorkTask& task)
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
      result = {result.item, true, worker.end()};
      worker = Worker (task_, workers_);
    }
    return result;
  }

  std::vector<std::size_t> items_;
  std::size_t next_{0};
  const WorkTask& task_;
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
                const WorkTask& task,
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
