// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/interruption.h"

#include <csignal>

namespace pcl_msf::tool {

namespace {

volatile std::sig_atomic_t signal_number = 0;

extern "C" void
noteSignal (int number)
{
  signal_number = number;
}

} // namespace

Interrupted::Interrupted()
: std::runtime_error ("interrupted; not everything is written")
{}

void
noteSignals ()
{
  struct sigaction action {};
  action.sa_handler = noteSignal;
  action.sa_flags = static_cast<int> (SA_RESETHAND);
  sigemptyset (&action.sa_mask);
  sigaction (SIGINT, &action, nullptr);
  sigaction (SIGTERM, &action, nullptr);
  struct sigaction before {};
  if (sigaction (SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
    sigaction (SIGHUP, &action, nullptr); // ignored: nohup wants it to go on
}

bool
interrupted ()
{
  return signal_number != 0;
}

void
throwIfInterrupted ()
{
  if (interrupted())
    throw Interrupted();
}

int
interruptedStatus ()
{
  return 128 + signal_number;
}

} // namespace pcl_msf::tool
