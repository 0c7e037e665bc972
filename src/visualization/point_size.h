// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/visualization/scene.h>
#include <pcl_msf/visualization/view.h>

namespace pcl_msf::visualization {

/** \brief Size of a set's points in pixels of the picture: what the style says, or as
 * large as the gaps between neighbours of an organized set. */
double
pointSize (const PointSet& set, const View& view, const PictureStyle& style);

} // namespace pcl_msf::visualization
