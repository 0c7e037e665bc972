// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "options.h"
#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/io/rgbd_sequence.h>

#include <memory>
#include <vector>

namespace pcl_msf::tool {

/** \brief All frames of a run: the files of the command line or a recording's. */
class Inputs {
public:
  /** \throws IoError, UsageError */
  explicit Inputs (const Options& options);

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

  /** \brief Frames first .. first + count - 1, read in parallel.
   * \throws IoError, UsageError when sizes differ */
  std::vector<io::RgbdImages>
  load (int first, int count) const;

  /** \brief CV_32SC1 of `size`; empty when a segmentation is to make them. */
  cv::Mat
  labels (const cv::Size& size) const;

private:
  io::RgbdImages
  loadFrame (int frame) const;
  void
  checkSizes (int first, const std::vector<io::RgbdImages>& images) const;

  const Options& options_;
  std::shared_ptr<const io::RgbdSequence> sequence_;
  int window_{2};
};

} // namespace pcl_msf::tool
