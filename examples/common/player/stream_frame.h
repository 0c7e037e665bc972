// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/rgbd_frame.h>

#include <chrono>
#include <string>

namespace pcl_msf::tool {

using StreamClock = std::chrono::steady_clock;

/** \brief A frame as it comes out of a camera. */
struct StreamFrame {
  int index{0};          ///< place in the recording, or how many came before
  double seconds{0.0};   ///< of the recording; its index when that has no times
  io::RgbdImages images; ///< that the frame was made of
  RgbdFrame frame;
  std::string problem; ///< why there is no frame; empty when there is one
  StreamClock::time_point arrival;
};

} // namespace pcl_msf::tool
