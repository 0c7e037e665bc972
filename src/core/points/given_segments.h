// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_clouds.h"

#include <vector>

namespace pcl_msf {

/** \brief Segments of a cloud from outside, numbered in ascending order of labels. */
struct GivenSegments {
  std::vector<int> labels; ///< of the segments, ascending; empty = none are given
  std::vector<int> of;     ///< per point, -1 = none; empty likewise

  /** \brief Number of the segment with a label, -1 = there is none. */
  int
  find (int label) const;
};

/** \brief Numbers segments that finite points bear.
 * \param labels one per point, negative = none; none at all = none are given
 * \throws InvalidInput naming the remedy when sizes differ or no point has one */
GivenSegments
numberSegments (const std::vector<int>& labels,
                const std::vector<Eigen::Vector3f>& points);

/** \brief The points' own labels, ascending and without gaps, in place of any others.
 * \param[in,out] labels >= 0 \return the labels before, ascending */
std::vector<int>
closeGaps (std::vector<int>& labels);

/** \brief The samples with more of segments that have few.
 * \param samples indices of points, ascending \param label per point
 * \param least samples of a segment, or all of its points */
std::vector<int>
sampleEach (const std::vector<int>& samples, const std::vector<int>& label, int least);

/** \brief Per given segment the one of the working cloud; one that has no working point
 * goes with that of the nearest. \param source as given */
std::vector<int>
workingSegments (const PointClouds& clouds,
                 const GivenSegments& given,
                 const std::vector<Eigen::Vector3f>& source);

} // namespace pcl_msf
