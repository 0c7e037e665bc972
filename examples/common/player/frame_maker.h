// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/player_settings.h"
#include "common/player/stream_frame.h"

#include <functional>
#include <optional>
#include <set>
#include <string>

namespace pcl_msf::tool {

/** \brief Is called with one line when something is not used, unlikely or lost. */
using Warn = std::function<void (const std::string&)>;

/** \brief Makes the images of a stream ready for the tracker, frame by frame. */
class FrameMaker {
public:
  /** \param name of the stream, for messages \param defines_depth_unit see
   * RgbdSequence::definesDepthUnit \param warn is called once for each kind of thing.
   * The settings must outlive the maker. */
  FrameMaker (const PlayerSettings& settings,
              std::string name,
              bool defines_depth_unit,
              Warn warn);

  /** \brief Fills in the images that `load` returns and what is made of them. What is
   * wrong with a frame is its `problem`, but the first one must be right: it tells
   * whether the stream is understood. Its unit of colour holds for all.
   * \throws IoError, InvalidInput, UsageError for that one */
  void
  make (StreamFrame& frame, const std::function<io::RgbdImages()>& load);

private:
  void
  take (StreamFrame& frame, io::RgbdImages images);
  void
  warnOnce (const std::string& kind, const std::string& text);

  const PlayerSettings& settings_;
  std::string name_;
  bool defines_depth_unit_;
  Warn warn_;
  std::set<std::string> warned_; ///< kinds
  std::optional<double> color_unit_;
  bool started_{false};
};

} // namespace pcl_msf::tool
