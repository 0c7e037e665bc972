// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "stream/frame_player.h"

#include "common/interruption.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf::tool {

namespace {

constexpr double kUsualRate = 30.0;                     // Hz
constexpr std::chrono::duration<double> kLongNap{0.02}; // between looks for a signal

/** When each frame comes, in seconds after the first one. */
std::vector<double>
dueTimes (const io::RgbdSequence& sequence, const std::optional<double>& rate)
{
  std::vector<double> due (sequence.frames());
  const double first = sequence.timestamp (0);
  for (int k = 0; k < sequence.frames(); ++k) {
    const double stamp = rate ? std::nan ("") : sequence.timestamp (k) - first;
    due[k] = std::isfinite (stamp) ? stamp : k / rate.value_or (kUsualRate);
    if (k > 0)
      due[k] = std::max (due[k], due[k - 1]);
  }
  return due;
}

} // namespace

FramePlayer::FramePlayer (const io::RgbdSequence& sequence,
                          const StreamOptions& options,
                          FrameReader& reader,
                          Queue& queue)
: reader_ (reader)
, queue_ (queue)
, every_frame_ (options.every_frame)
, due_ (dueTimes (sequence, options.rate))
, thread_ ([this] { run(); })
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
    play();
  }
  catch (...) {
    error_ = std::current_exception();
  }
  queue_.close();
}

void
FramePlayer::play()
{
  const int frames = static_cast<int> (due_.size());
  for (int k = 0; k < frames && waitUntilDue (k); ++k) {
    if (isLate (k)) {
      ++skipped_;
      continue;
    }
    StreamFrame frame = reader_.read (k);
    if (k == 0)
      start_ = frame.arrival;
    const bool taken = every_frame_ ? queue_.pushWhenThereIsRoom (std::move (frame))
                                    : queue_.push (std::move (frame));
    if (!taken)
      return;
  }
}

/** \return false when the stream is to end before */
bool
FramePlayer::waitUntilDue (int frame) const
{
  while (!stop_ && !interrupted()) {
    if (frame == 0 || every_frame_)
      return true;
    const auto now = StreamClock::now() - start_;
    const std::chrono::duration<double> left =
        std::chrono::duration<double> (due_[frame]) - now;
    if (left.count() <= 0.0)
      return true;
    std::this_thread::sleep_for (std::min (left, kLongNap));
  }
  return false;
}

bool
FramePlayer::isLate (int frame) const
{
  const bool last = frame + 1 == static_cast<int> (due_.size());
  return frame > 0 && !last && !every_frame_ &&
         StreamClock::now() - start_ > std::chrono::duration<double> (due_[frame + 1]);
}

} // namespace pcl_msf::tool
