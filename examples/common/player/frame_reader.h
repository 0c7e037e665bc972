// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/player_settings.h"
#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/rgbd_frame.h>

#include <chrono>
#include <functional>
#include <optional>
#include <set>
#include <string>

namespace pcl_msf::tool {

using StreamClock = std::chrono::steady_clock;

/** \brief A frame as it comes out of a camera. */
struct StreamFrame {
  int index{0};          ///< place in the recording
  double seconds{0.0};   ///< of the recording; its index when that has no times
  io::RgbdImages images; ///< that the frame was made of
  RgbdFrame frame;
  std::string problem; ///< why there is no frame; empty when there is one
  StreamClock::time_point arrival;
};

/** \brief Reads frames of a recording and makes them ready for the tracker, one by one.
 */
class FrameReader {
public:
  using Warn = std::function<void (const std::string&)>;

  /** \param warn is called with one line when something of a frame is not used or
   * unlikely, once for each kind of thing. All must outlive the reader. */
  FrameReader (const io::RgbdSequence& sequence,
               const PlayerSettings& options,
               Warn warn);

  /** \brief What is wrong with a frame is its `problem`, but the first one that is read
   * must be right: it tells whether the recording is understood. Its unit of colour
   * holds for all. \throws IoError, InvalidInput, UsageError for that one */
  StreamFrame
  read (int index);

private:
  void
  load (StreamFrame& into);
  void
  warnOnce (const std::string& kind, const std::string& text);

  const io::RgbdSequence& sequence_;
  const PlayerSettings& options_;
  Warn warn_;
  std::set<std::string> warned_; ///< kinds
  std::optional<double> color_unit_;
  bool started_{false};
};

} // namespace pcl_msf::tool
