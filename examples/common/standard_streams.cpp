// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/standard_streams.h"

#include <fcntl.h>
#include <pcl_msf/errors.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace pcl_msf::tool {

namespace {

volatile std::sig_atomic_t reader_is_gone = 0;

extern "C" void
noteBrokenPipe (int)
{
  reader_is_gone = 1;
}

} // namespace

void
keepStandardStreams ()
{
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl (stream, F_GETFD) == -1)
      open ("/dev/null", O_RDWR); // gets the lowest number that is free: this one
  // Not SIG_IGN, which a program that is started from here would inherit.
  struct sigaction action {};
  action.sa_handler = noteBrokenPipe;
  action.sa_flags = SA_RESTART;
  sigemptyset (&action.sa_mask);
  sigaction (SIGPIPE, &action, nullptr);
}

bool
standardOutputIsLost ()
{
  return std::ferror (stdout) != 0;
}

void
finishStandardOutput ()
{
  const bool written = std::fflush (stdout) == 0 && !standardOutputIsLost();
  if (!written && reader_is_gone == 0)
    throw IoError ("standard output: cannot be written; check that there is space, or "
                   "send it elsewhere");
}

} // namespace pcl_msf::tool
