// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "options.h"
#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/io/rgbd_sequence.h>

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief All frames of a run: the files of the command line or a recording's. */
class Inputs {
public:
  using Warn = std::function<void (const std::string&)>;

  /** \param warn is called with one line when something of the input is not used or
   * unlikely, once for each kind of thing \throws IoError, UsageError */
  Inputs (const Options& options, Warn warn);

  int
  frames () const;

  /** \brief Frames solved jointly. */
  int
  window () const
  {
    return window_;
  }

  /** \brief Seconds; the frame's index when the recording has none. */
  double
  timestamp (int frame) const;

  /** \brief Frames first .. first + count - 1, read in parallel, their colours in one
   * unit; all have colours or none. When frames are tracked they come one by one, and
   * the first one's unit holds for all. \throws IoError, UsageError when sizes differ
   */
  std::vector<io::RgbdImages>
  load (int first, int count);

  /** \brief CV_32SC1 of `size`; empty when a segmentation is to make them. */
  cv::Mat
  labels (const cv::Size& size) const;

private:
  io::RgbdImages
  loadFrame (int frame) const;
  std::string
  nameOf (int frame) const;
  void
  checkSizes (int first, const std::vector<io::RgbdImages>& images) const;
  void
  checkContent (int first, const std::vector<io::RgbdImages>& images);
  void
  unifyColors (int first, std::vector<io::RgbdImages>& images);
  void
  warnOnce (const std::string& kind, const std::string& text);

  const Options& options_;
  Warn warn_;
  std::set<std::string> warned_; ///< kinds
  std::shared_ptr<const io::RgbdSequence> sequence_;
  int window_{2};
  std::optional<double> color_unit_; ///< of the first frame, when tracking
};

} // namespace pcl_msf::tool
