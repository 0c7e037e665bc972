// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <pcl_msf/export.h>
#include <pcl_msf/visualization/scene.h>

#include <vector>

namespace pcl_msf::visualization {

/** \brief Points as vertices, and their triangles; null when the set has none. \param
 * pixels size of each \param behind moves them back a little, so that arrows and lines
 * on them are seen \throws InvalidInput when the images do not fit */
PCL_MSF_EXPORT vtkSmartPointer<vtkActor>
pointActor (const PointSet& set, double pixels, bool behind);

/** \brief Arrows as lit solids; null without arrows. */
PCL_MSF_EXPORT vtkSmartPointer<vtkActor>
arrowActor (const std::vector<Arrow>& arrows);

/** \brief Polylines; null without lines. \param pixels their width \param behind moves
 * them back a little, so that lines in the same place are seen */
PCL_MSF_EXPORT vtkSmartPointer<vtkActor>
lineActor (const std::vector<Polyline>& lines, double pixels, bool behind);

} // namespace pcl_msf::visualization
