// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data_term.h"
#include "core/segment_pixels.h"
#include <pcl_msf/rgbd_frame.h>

namespace pcl_msf {

/** \brief What one level of a frame pair needs: all reference points grouped by
 * segment, a sample of them for comparing poses, and the current frame's texture. */
struct LevelData {
  SegmentPixels pixels;
  SegmentPixels probes;
  Texture texture;
  double focal_length; ///< pixels of the level

  /** \param with_pixels false: probes only */
  LevelData (const FrameLevel& reference,
             const FrameLevel& current,
             const cv::Mat& labels,
             int segments,
             const NoiseModel& noise,
             double relative_tolerance,
             const BrightnessChange& change,
             bool with_pixels,
             int threads)
  : texture (current), focal_length (reference.camera.fx)
  {
    constexpr int kProbesPerSegment = 64;
    PointOptions options{noise, relative_tolerance, change, kProbesPerSegment, threads};
    probes = groupPixels (reference, labels, segments, options);
    options.max_per_segment = 0;
    if (with_pixels)
      pixels = groupPixels (reference, labels, segments, options);
  }
};

} // namespace pcl_msf
