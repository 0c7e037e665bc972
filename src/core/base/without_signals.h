// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pthread.h>

#include <csignal>

namespace pcl_msf {

/** \brief Threads that are started meanwhile get no signals: the application's handlers
 * run in its own threads. */
class WithoutSignals {
public:
  WithoutSignals()
  {
    sigset_t all;
    sigfillset (&all);
    pthread_sigmask (SIG_SETMASK, &all, &before_);
  }
  ~WithoutSignals() { pthread_sigmask (SIG_SETMASK, &before_, nullptr); }
  WithoutSignals (const WithoutSignals&) = delete;
  WithoutSignals&
  operator= (const WithoutSignals&) = delete;

private:
  sigset_t before_{};
};

} // namespace pcl_msf
