// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/tuning/start_tuning.h"
#include "core/motion/rigid_fit.h"
#include "core/segments/segment_pixels.h"
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf {

/** \brief Samples of all segments; those of segment k are [begin[k], begin[k + 1]). */
struct SampleTable {
  std::vector<FlowSample> samples;
  std::vector<int> begin;
};

/** \brief Motions that optical flow suggests: starts for segments, never results. */
struct FlowHypotheses {
  SampleTable samples;
  std::vector<RigidPose> of_segment; ///< robust rigid fit to each segment's flow
  std::vector<char> fitted;          ///< enough samples for the fit?
  std::vector<RigidPose> bodies; ///< motions that many segments share, largest first
  MatchedIntensities matches;
};

/** \brief Dense optical flow at a part of the frames' resolution. */
struct CoarseFlow {
  cv::Mat flow; ///< CV_32FC2, its own pixels
  int level{0}; ///< the frames' sides are 2^level times as long

  /** \brief Flow of a pixel of the frames, in their pixels. */
  cv::Vec2f
  at (int x, int y) const;

  /** \brief Flow of all pixels of frames of a size; empty when this is. */
  cv::Mat
  ofSize (const cv::Size& frames) const;
};

/** \brief Flow from the reference to the current frame at half resolution, by cv's DIS:
 * the finest that its medium preset computes. */
CoarseFlow
estimateOpticalFlow (const RgbdFrame& reference,
                     const RgbdFrame& current,
                     const FlowTuning& tuning,
                     int threads);

/** \brief The same on the images of inverse depth, at a quarter: follows thin and
 * textureless things in front of a background, and frames without colour. By the
 * calling thread alone. */
CoarseFlow
estimateDepthFlow (const RgbdFrame& reference,
                   const RgbdFrame& current,
                   const FlowTuning& tuning);

/** \brief Lifts optical flow by depth and fits rigid motions (robustly).
 * \param samples points of the reference at a level
 * \param wanted per segment, 0 = leave it out
 * \param level index of that level
 * \param start where the fits begin */
FlowHypotheses
hypothesesFromFlow (const CoarseFlow& flow,
                    const RgbdFrame& current,
                    const SegmentPixels& samples,
                    const std::vector<char>& wanted,
                    int level,
                    const NoiseModel& noise,
                    const RigidPose& start,
                    const StartTuning& tuning,
                    int threads);

} // namespace pcl_msf
