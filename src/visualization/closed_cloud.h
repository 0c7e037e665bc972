// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/visualization/scene.h>

namespace pcl_msf::visualization {

/** \brief A moved cloud whose cracks are closed.
 *
 * Neighbouring segments that move a little apart leave cracks of a few pixels on what
 * is one surface. Neighbours on one surface of the unmoved cloud get triangles between
 * them where the motion has pulled them apart, up to a width at which the surface
 * counts as torn. \param points CV_32FC3, metres, the cloud before, organized \param
 * moved the same points after; NaN = unknown \param colors CV_8UC3 */
PointSet
closedCloud (const cv::Mat& points, const cv::Mat& moved, const cv::Mat& colors);

} // namespace pcl_msf::visualization
