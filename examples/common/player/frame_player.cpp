// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/frame_player.h"

#include "common/interruption.h"

namespace pcl_msf::tool {

FramePlayer::FramePlayer (FrameSource& source, Queue& queue)
: source_ (source), queue_ (queue), thread_ ([this] { run(); })
{}

FramePlayer::~FramePlayer()
{
  stop_ = true;
  queue_.close();
  if (thread_.joinable())
    thread_.join();
}

void
FramePlayer::requireFrames()
{
  stop_ = true;
  if (thread_.joinable())
    thread_.join();
  if (error_)
    std::rethrow_exception (error_);
}

void
FramePlayer::run()
{
  try {
    source_.deliver (queue_, [this] { return stop_ || interrupted(); });
  }
  catch (...) {
    error_ = std::current_exception();
  }
  queue_.close();
}

} // namespace pcl_msf::tool
