// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "worker_pool.h"
#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Does a piece; an exception becomes a failed result. */
WorkResult
attempt (const WorkTask& task, std::size_t item);

/** \brief A process that does pieces of work, and the pipes to it. */
class Worker {
public:
  /** \brief Starts the process, a fork.
   * \param others whose pipes it must not hold open
   * \throws std::runtime_error when it cannot be started */
  Worker (const WorkTask& task, const std::vector<Worker>& others);

  bool
  busy () const
  {
    return busy_;
  }
  /** \brief File descriptor that is readable when an answer is there. */
  int
  answers () const
  {
    return answers_;
  }

  /** \brief Hands it a piece. */
  void
  give (std::size_t item);

  /** \brief Waits for the result of that piece.
   * \param[out] alive false when the process is dead and there is no result */
  WorkResult
  take (bool& alive);

  /** \brief Ends the process after its present piece and waits for it.
   * \return how it ended, as text */
  std::string
  end ();

private:
  pid_t process_;
  int requests_;
  int answers_;
  std::size_t item_{0};
  bool busy_{false};
};

} // namespace pcl_msf::tool
