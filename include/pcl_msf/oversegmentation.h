// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/PointIndices.h>

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/rgbd_frame.h>

#include <vector>

namespace pcl_msf {

/** \brief The reference frame cut into segments S_k (section 3 and 3.3).
 *
 * A label image of the frame's size: CV_32SC1, 0 .. segments - 1, -1 where a point
 * belongs to no segment (no depth, or left out by the caller). Labels are dense: every
 * one has a point. Lengths are in the frame's pixels.
 */
class PCL_MSF_EXPORT Oversegmentation {
public:
  Oversegmentation() = default;

  /** \brief Cuts a frame. Deterministic.
   * \param threads to use, OpenCV's included; 0 = all. The result does not depend on
   * it. \throws InvalidInput for bad parameters */
  static Oversegmentation
  fromFrame (const RgbdFrame& frame,
             const SegmentationParameters& parameters = {},
             unsigned threads = 1);

  /** \brief Takes labels from outside, any integers; those that no point with depth
   * bears disappear, the others are renumbered in ascending order. Negative labels =
   * no segment. \param labels CV_32SC1, of the frame's size or its input's
   * \throws InvalidInput when the size differs from these or nothing is left */
  static Oversegmentation
  fromLabels (const cv::Mat& labels, const RgbdFrame& frame);

  /** \brief Takes clusters of pixel indices of the frame's input (row * width +
   * column), as PCL's segmentations give them. A point in several clusters belongs to
   * the first. \throws InvalidInput for indices outside the input or when nothing is
   * left */
  static Oversegmentation
  fromIndices (const std::vector<pcl::PointIndices>& clusters, const RgbdFrame& frame);

  const cv::Mat&
  labels () const
  {
    return labels_;
  }
  int
  size () const
  {
    return size_;
  }

private:
  cv::Mat labels_;
  int size_{0};
};

} // namespace pcl_msf
