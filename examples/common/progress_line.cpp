// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace pcl_msf::tool {

namespace {

constexpr const char* kClearLine = "\r\033[K";

} // namespace

ProgressLine::ProgressLine (bool wanted)
: shown_ (wanted && isatty (fileno (stderr)) != 0)
{}

ProgressLine::~ProgressLine()
{
  if (shown_)
    std::fputs (kClearLine, stderr);
}

void
ProgressLine::stage (const char* name)
{
  if (shown_)
    std::fprintf (stderr, "%s[    ] %s", kClearLine, name);
}

void
ProgressLine::update (const Progress& progress)
{
  if (!shown_)
    return;
  const double percent = 100.0 * std::clamp (progress.fraction, 0.0, 1.0);
  std::fprintf (stderr,
                "%s[%3.0f%%] %s, level %d, iteration %d, cost %.6g",
                kClearLine,
                percent,
                progress.stage,
                progress.level,
                progress.iteration,
                progress.cost);
}

} // namespace pcl_msf::tool
