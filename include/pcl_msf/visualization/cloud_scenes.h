// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/cloud_flow.h>
#include <pcl_msf/export.h>
#include <pcl_msf/visualization/result_scenes.h>
#include <pcl_msf/visualization/scene.h>
#include <pcl_msf/visualization/view.h>

#include <vector>

namespace pcl_msf::visualization {

/** \brief Two clouds without a grid and what a registration says of them. Points that
 * are not finite are left out. */
struct CloudResult {
  std::vector<Eigen::Vector3f> source;
  std::vector<Eigen::Vector3f> warped; ///< per source point
  std::vector<int> part;               ///< per source point, -1 = none
  std::vector<CloudJoint> joints;      ///< source frame
  std::vector<Eigen::Vector3f> target; ///< empty = unknown
};

/** \brief Kinds that there are of clouds: BeforeTints, AfterTints, Warped, and Motions,
 * which shows the parts and the joints' axes in the source's pose. */
PCL_MSF_EXPORT const std::vector<PictureKind>&
cloudKinds ();

/** \brief Builds the scene of a kind; clouds are lit by the shape that they sample.
 * \throws InvalidInput for other kinds, without points, or when the kind shows the
 * target and there is none */
PCL_MSF_EXPORT Scene
cloudScene (PictureKind kind, const CloudResult& result);

/** \brief The middle and extent of all finite points: feet and tails have few. As
 * SceneBounds{} when there are none. */
PCL_MSF_EXPORT SceneBounds
cloudBounds (const std::vector<Eigen::Vector3f>& points);

/** \brief About the distance between neighbouring points, in their unit. */
PCL_MSF_EXPORT double
cloudSpacing (const std::vector<Eigen::Vector3f>& points);

} // namespace pcl_msf::visualization
