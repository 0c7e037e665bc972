// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/errors.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace pcl_msf {

/** \brief Frames on their way from a camera's thread to the thread that solves them.
 *
 * It is bounded: when the camera is faster, the oldest frame that waits is dropped, and
 * counted, so that what is solved next is what has just been seen.
 *
 * \code
 * pcl_msf::FrameQueue<Cloud::ConstPtr> queue;
 * grabber.registerCallback<void (const Cloud::ConstPtr&)> (
 *     [&] (const Cloud::ConstPtr& cloud) { queue.push (cloud); });
 * grabber.start ();
 * while (const auto cloud = queue.pop ()) // until somebody calls queue.close ()
 *   tracker.addCloud (*cloud);
 * \endcode
 *
 * Thread-safe: any thread may call any member at any time; frames leave in the order in
 * which they came. It starts no thread, and must outlive the calls: close it and join
 * its users before it goes. A `Frame` is moved, never copied.
 */
template <typename Frame>
class FrameQueue {
public:
  /** \param capacity frames that may wait, at least 1; with 1 (default) what is solved
   * is never older than one frame \throws InvalidInput */
  explicit FrameQueue (int capacity = 1)
  : capacity_ (static_cast<std::size_t> (capacity))
  {
    if (capacity < 1)
      throw InvalidInput ("frame queue: capacity is " + std::to_string (capacity) +
                          ", must be at least 1");
  }
  FrameQueue (const FrameQueue&) = delete;
  FrameQueue&
  operator= (const FrameQueue&) = delete;

  /** \brief Adds a frame and never waits: when the queue is full, its oldest frame is
   * dropped. \return false when the queue is closed; then the frame is not taken */
  bool
  push (Frame frame)
  {
    std::optional<Frame> oldest; // freed without the lock
    const std::lock_guard<std::mutex> lock (mutex_);
    if (closed_)
      return false;
    if (isFull()) {
      oldest = takeOldest();
      ++dropped_;
    }
    put (std::move (frame));
    return true;
  }

  /** \brief Adds a frame once there is room, for sources that can wait: none is
   * dropped. \return false when the queue is or gets closed; then it is not taken */
  bool
  pushWhenThereIsRoom (Frame frame)
  {
    std::unique_lock<std::mutex> lock (mutex_);
    room_.wait (lock, [this] { return closed_ || !isFull(); });
    if (closed_)
      return false;
    put (std::move (frame));
    return true;
  }

  /** \brief Takes the oldest frame; waits for one. \return none once the queue is
   * closed and empty */
  std::optional<Frame>
  pop ()
  {
    std::unique_lock<std::mutex> lock (mutex_);
    arrival_.wait (lock, [this] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty())
      return std::nullopt;
    std::optional<Frame> frame = takeOldest();
    room_.notify_one();
    return frame;
  }

  /** \brief No frame is taken any more; those that wait can still be popped. Wakes
   * whoever waits. Closing again changes nothing. */
  void
  close ()
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    closed_ = true;
    arrival_.notify_all();
    room_.notify_all();
  }

  /** \brief How many frames push() has dropped so far. */
  long
  dropped () const
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    return dropped_;
  }

private:
  // All with the lock held.
  bool
  isFull () const
  {
    return waiting_.size() >= capacity_;
  }
  Frame
  takeOldest ()
  {
    Frame frame = std::move (waiting_.front());
    waiting_.pop_front();
    return frame;
  }
  void
  put (Frame frame)
  {
    waiting_.push_back (std::move (frame));
    arrival_.notify_one();
  }

  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable arrival_; ///< of a frame, or the end
  std::condition_variable room_;    ///< for a frame, or the end
  std::deque<Frame> waiting_;
  long dropped_{0};
  bool closed_{false};
};

} // namespace pcl_msf
