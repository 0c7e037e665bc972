// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "run_progress.h"

#include <unistd.h>

#include <cstdio>

namespace pcl_msf::tool {

namespace {

constexpr const char* kClearLine = "\r\033[K";
constexpr double kSecondsBetweenLines = 10.0;

} // namespace

std::string
durationText (double seconds)
{
  const auto whole = static_cast<long> (seconds + 0.5);
  char text[64];
  if (whole < 100)
    std::snprintf (text, sizeof text, "%ld s", whole);
  else if (whole < 6000)
    std::snprintf (text, sizeof text, "%ld min", (whole + 30) / 60);
  else
    std::snprintf (
        text, sizeof text, "%ld h %02ld min", whole / 3600, whole % 3600 / 60);
  return text;
}

RunProgress::RunProgress (std::size_t todo, bool wanted)
: todo_ (todo), wanted_ (wanted), terminal_ (isatty (fileno (stderr)) != 0)
{}

RunProgress::~RunProgress() { clear(); }

void
RunProgress::clear() const
{
  if (wanted_ && terminal_)
    std::fputs (kClearLine, stderr);
}

void
RunProgress::step (const std::string& name)
{
  ++done_;
  const auto now = Clock::now();
  const double since_last = std::chrono::duration<double> (now - last_).count();
  if (!wanted_ || (!terminal_ && since_last < kSecondsBetweenLines))
    return;
  last_ = now;
  const double spent = std::chrono::duration<double> (now - start_).count();
  const auto left = static_cast<double> (todo_ - done_);
  const double remaining = spent / static_cast<double> (done_) * left;
  std::fprintf (stderr,
                "%s[%zu of %zu pairs, %s gone, about %s left] %s%s",
                terminal_ ? kClearLine : "",
                done_,
                todo_,
                durationText (spent).c_str(),
                durationText (remaining).c_str(),
                name.c_str(),
                terminal_ ? "" : "\n");
}

} // namespace pcl_msf::tool
