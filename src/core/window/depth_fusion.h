// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/tuning/window_tuning.h"
#include "core/motion/motion_state.h"
#include "core/segments/segment_pixels.h"
#include <pcl_msf/rgbd_frame.h>

#include <vector>

namespace pcl_msf {

/** \brief A frame that measures the reference's points once more. */
struct DepthSource {
  const FrameLevel* level;
  MotionState motion; ///< from the reference
};

/** \brief The reference's inverse depth, averaged with what other frames measure at the
 * places that the poses carry its points to.
 *
 * A sensor's depth noise moves every point along its ray, and with it its optical flow,
 * by a share of the motion: as many measurements as frames reduce it. Each counts by
 * its variance, which for the sources includes what poses and interpolation leave;
 * those that differ by more than the noise explains see something else and do not
 * count. */
class DepthFusion {
public:
  DepthFusion() = default;
  /** \param reference level \param labels of it, -1 = none */
  DepthFusion (const FrameLevel& reference, const cv::Mat& labels);

  /** \brief Adds a frame's measurements. \param noise of the frames */
  void
  add (const DepthSource& source,
       const NoiseModel& noise,
       const FusionTuning& tuning,
       int threads);

  /** \brief CV_32FC1, 1 / metres, 0 where the reference has none; empty before a frame
   * was added. */
  cv::Mat
  average () const;

private:
  PinholeCamera camera_;
  cv::Mat inverse_depth_, labels_; ///< of the reference
  cv::Mat sums_;                   ///< CV_32FC2: of weights, of weighted changes
};

} // namespace pcl_msf
