// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/synthetic/synthetic_sequence.h>
#include <synthetic/frame_view.h>

#include <vector>

namespace pcl_msf::synthetic {

/** \brief What a structured-light sensor of the first Kinect's kind does to depth:
 * CV_32F, metres, changed in place.
 *
 * Disparity (580 px focal length, 0.075 m baseline) gets Gaussian noise of 0.06 px and
 * is rounded to 1/8 px, so errors in metres grow with z^2. No measurement: in the
 * projector's shadow beside nearer surfaces; in ragged borders of depth edges; on
 * surfaces seen at more than about 80 deg; nearer than 0.4 m or with a disparity below
 * one pixel (43.5 m). \param key tells frames and seeds apart */
void
applyKinectDepth (const FrameView& view,
                  const std::vector<ViewHit>& hits,
                  std::uint64_t key,
                  int threads,
                  cv::Mat& depth);

/** \brief And to colour: CV_32FC3, 0 .. 255, changed in place: vignette (12 % darker
 * corners), exposure that differs by up to 3 % from frame to frame, Gaussian noise of
 * 2.5 / 255. */
void
applyKinectColor (std::uint64_t key, int threads, cv::Mat& color);

} // namespace pcl_msf::synthetic
