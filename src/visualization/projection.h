// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/visualization/scene.h>
#include <pcl_msf/visualization/view.h>

namespace pcl_msf::visualization {

/** \brief Depth range of a scene in a view, metres along its line of sight. */
struct DepthRange {
  double near{0.0};
  double far{0.0};
};

/** \brief The range that clipping planes have to leave. */
DepthRange
depthRange (const Scene& scene, const View& view);

/** \brief The view as OpenGL's 4x4 projection from VTK's eye frame (x right, y up, z
 * backwards), row by row. */
Eigen::Matrix4d
projectionMatrix (const View& view, const DepthRange& range);

} // namespace pcl_msf::visualization
