// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/frame_source.h"

#include <atomic>
#include <exception>
#include <thread>

namespace pcl_msf::tool {

/** \brief Lets a source deliver into a queue, in a thread of its own, and closes the
 * queue at the source's end or after a signal. */
class FramePlayer {
public:
  using Queue = FrameSource::Queue;

  /** \brief Begins. Both must outlive the player; the source is its own meanwhile. */
  FramePlayer (FrameSource& source, Queue& queue);

  /** \brief Closes the queue and waits for the thread. */
  ~FramePlayer();
  FramePlayer (const FramePlayer&) = delete;
  FramePlayer&
  operator= (const FramePlayer&) = delete;

  /** \brief Why there was no first frame, if so; once the queue is closed.
   * \throws what FrameSource::deliver does */
  void
  requireFrames ();

private:
  void
  run ();

  FrameSource& source_;
  Queue& queue_;
  std::atomic<bool> stop_{false};
  std::exception_ptr error_; ///< of the thread, read when it has ended
  std::thread thread_;
};

} // namespace pcl_msf::tool
