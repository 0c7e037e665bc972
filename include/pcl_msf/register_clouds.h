// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/piecewise_rigid_registration.h>

#include <utility>

namespace pcl_msf {

/** \brief What registerClouds finds. */
template <typename PointT>
struct RegisteredClouds {
  /** \brief false: scene_flow.report.message says why, and it is on stderr. */
  bool converged{false};

  /** \brief The source carried to the target, organized like it; NaN where the motion
   * is unknown. The source itself after a failure. */
  pcl::PointCloud<PointT> warped;

  /** \brief Displacements in metres, flow in pixels, segments with their poses, motion
   * groups, visibility, and the report. Images are empty after a failure. */
  SceneFlow scene_flow;
};

/** \brief Registers two organized clouds with the default parameters: the one call to
 * begin with. PiecewiseRigidRegistration takes parameters, more targets and callbacks.
 *
 * \code
 * const auto result = pcl_msf::registerClouds (reference, current);
 * if (result.converged)
 *   pcl::io::savePCDFileBinary ("warped.pcd", result.warped);
 * \endcode
 *
 * \param source, target pointers to clouds, Ptr or ConstPtr each, of the camera's
 * optical frame, in metres, NaN where there is no depth; of the same size. Throws
 * nothing; thread-safe. */
template <typename CloudPtr,
          typename PointT = typename CloudPtr::element_type::PointType>
RegisteredClouds<PointT>
registerClouds (const CloudPtr& source,
                const typename pcl::PointCloud<PointT>::ConstPtr& target)
{
  PiecewiseRigidRegistration<PointT> registration;
  registration.setInputSource (source);
  registration.setInputTarget (target);
  RegisteredClouds<PointT> result;
  registration.align (result.warped);
  result.converged = registration.hasConverged();
  result.scene_flow = registration.getSceneFlow();
  return result;
}

/** \brief The same for clouds that no pointer holds; they are copied. */
template <typename PointT>
RegisteredClouds<PointT>
registerClouds (const pcl::PointCloud<PointT>& source,
                const pcl::PointCloud<PointT>& target)
{
  using Cloud = pcl::PointCloud<PointT>;
  return registerClouds (pcl::make_shared<Cloud> (source),
                         pcl::make_shared<Cloud> (target));
}

} // namespace pcl_msf
