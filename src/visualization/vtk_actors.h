// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <pcl_msf/visualization/scene.h>
#include <pcl_msf/visualization/view.h>

namespace pcl_msf::visualization {

/** \brief Depth range of a scene in a view, metres along its line of sight. */
struct DepthRange {
  double near{0.0};
  double far{0.0};
};

/** \brief Points as vertices; null when the set has none. \param pixels size of each
 * \param behind moves them back a little, so that arrows and lines on them are seen
 * \throws InvalidInput when the images do not fit */
vtkSmartPointer<vtkActor>
pointActor (const PointSet& set, double pixels, bool behind);

/** \brief Arrows as lit solids; null without arrows. */
vtkSmartPointer<vtkActor>
arrowActor (const std::vector<Arrow>& arrows);

/** \brief Polylines; null without lines. \param pixels their width */
vtkSmartPointer<vtkActor>
lineActor (const std::vector<Polyline>& lines, double pixels);

/** \brief The range that clipping planes have to leave. */
DepthRange
depthRange (const Scene& scene, const View& view);

/** \brief The view as OpenGL's 4x4 projection from VTK's eye frame (x right, y up, z
 * backwards), row by row. */
Eigen::Matrix4d
projectionMatrix (const View& view, const DepthRange& range);

} // namespace pcl_msf::visualization
