// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/recording_source.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

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

RecordingSource::RecordingSource (std::shared_ptr<const io::RgbdSequence> sequence,
                                  const PlayerSettings& settings,
                                  Warn warn)
: sequence_ (std::move (sequence))
, every_frame_ (settings.every_frame)
, maker_ (settings, settings.source, sequence_->definesDepthUnit(), std::move (warn))
, due_ (dueTimes (*sequence_, settings.rate))
{}

StreamFrame
RecordingSource::read (int index)
{
  StreamFrame frame;
  frame.index = index;
  const double seconds = sequence_->timestamp (index);
  frame.seconds = std::isfinite (seconds) ? seconds : index;
  maker_.make (frame, [&] { return sequence_->frame (index); });
  frame.arrival = StreamClock::now();
  return frame;
}

void
RecordingSource::deliver (Queue& queue, const std::function<bool()>& ended)
{
  const int frames = static_cast<int> (due_.size());
  for (int k = 0; k < frames && waitUntilDue (k, ended); ++k) {
    if (isLate (k)) {
      ++skipped_;
      continue;
    }
    StreamFrame frame = read (k);
    if (k == 0)
      start_ = frame.arrival;
    const bool taken = every_frame_ ? queue.pushWhenThereIsRoom (std::move (frame))
                                    : queue.push (std::move (frame));
    if (!taken)
      return;
  }
}

/** \return false when the stream is to end before */
bool
RecordingSource::waitUntilDue (int frame, const std::function<bool()>& ended) const
{
  while (!ended()) {
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
RecordingSource::isLate (int frame) const
{
  const bool last = frame + 1 == static_cast<int> (due_.size());
  return frame > 0 && !last && !every_frame_ &&
         StreamClock::now() - start_ > std::chrono::duration<double> (due_[frame + 1]);
}

} // namespace pcl_msf::tool
