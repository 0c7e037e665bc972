// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/stream_frame.h"
#include <pcl_msf/frame_queue.h>

#include <functional>

namespace pcl_msf::tool {

/** \brief Where the frames of a stream come from: a recording or a camera. */
class FrameSource {
public:
  using Queue = FrameQueue<StreamFrame>;

  virtual ~FrameSource() = default;

  /** \brief Puts the frames into the queue as they come, until there are no more, the
   * queue is closed, or `ended` says so; called once. Frames may come by other threads,
   * but none after the return.
   * \throws whatever is wrong with the first frame, or why there is none */
  virtual void
  deliver (Queue& queue, const std::function<bool()>& ended) = 0;

  /** \brief How many frames were left out so far, beside those that the queue dropped;
   * for any thread. */
  virtual long
  skipped () const = 0;
};

} // namespace pcl_msf::tool
