// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief What a piece of work gave. */
struct WorkResult {
  std::size_t item{0};
  bool failed{false};
  std::string text; ///< what the task returned, or why it failed
};

/** \brief Does the piece of a number; may throw. */
using WorkTask = std::function<std::string (std::size_t)>;

/** \brief Does pieces of work in processes of its own, so that many run at once and one
 * that dies takes nothing with it.
 *
 * Make it before any thread is started: the processes are forks.
 * \param jobs processes; 1 = in the calling process
 * \param items numbers of the pieces, handed out in this order
 * \param done is told each result in the calling process as it comes; false = hand out
 * no more
 * \throws std::runtime_error when no process can be started, and what `done` throws */
void
runInProcesses (int jobs,
                const std::vector<std::size_t>& items,
                const WorkTask& task,
                const std::function<bool (const WorkResult&)>& done);

} // namespace pcl_msf::tool
