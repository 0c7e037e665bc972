// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/frame_reader.h"
#include <pcl_msf/frame_queue.h>

#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace pcl_msf::tool {

/** \brief Plays a recording into a queue, in a thread of its own, and closes the queue
 * at its end or after a signal.
 *
 * The first frame comes at once, the others as long after it as their times say. One
 * that is so late, because reading takes long, that the next one is due already is left
 * out. When every frame is wanted, each comes as soon as there is room for it. */
class FramePlayer {
public:
  using Queue = FrameQueue<StreamFrame>;

  /** \brief Begins. All must outlive the player; the reader and the recording are its
   * own meanwhile. */
  FramePlayer (const io::RgbdSequence& sequence,
               const PlayerSettings& options,
               FrameReader& reader,
               Queue& queue);

  /** \brief Closes the queue and waits for the thread. */
  ~FramePlayer();
  FramePlayer (const FramePlayer&) = delete;
  FramePlayer&
  operator= (const FramePlayer&) = delete;

  /** \brief How many frames were left out so far. */
  long
  skipped () const
  {
    return skipped_;
  }

  /** \brief Why there was no first frame, if so; once the queue is closed.
   * \throws what FrameReader::read does */
  void
  requireFrames ();

private:
  void
  run ();
  void
  play ();
  bool
  waitUntilDue (int frame) const;
  bool
  isLate (int frame) const;

  FrameReader& reader_;
  Queue& queue_;
  bool every_frame_;
  std::vector<double> due_; ///< per frame, seconds after the first; never decreasing
  StreamClock::time_point start_;
  std::atomic<long> skipped_{0};
  std::atomic<bool> stop_{false};
  std::exception_ptr error_; ///< of the thread, read when it has ended
  std::thread thread_;
};

} // namespace pcl_msf::tool
