// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/export.h>
#include <pcl_msf/scene_flow_settings.h>
#include <pcl_msf/scene_flow_tracker.h>

namespace pcl_msf {

/** \brief SceneFlowTracker on organized clouds: cloud in, scene flow out.
 *
 * \code
 * pcl_msf::PiecewiseRigidTracker<pcl::PointXYZRGBA> tracker;
 * grabber_callback = [&] (const Cloud::ConstPtr& cloud) {
 *   if (tracker.addCloud (cloud) && tracker.getSceneFlow ().report.converged)
 *     use (tracker.getSceneFlow (), tracker.getCameraPose ());
 * };
 * \endcode
 *
 * Clouds are those of PiecewiseRigidRegistration, settings those that make sense for a
 * reference that changes: none from outside. A setting changed between clouds takes
 * effect at the next restart. Without setCamera the camera is estimated from the first
 * cloud. Memory does not grow with the number of clouds. A cloud is copied when it is
 * added: its object may be filled anew for the next one. One that was moved from keeps
 * its settings and begins anew, as after restart. Not thread-safe; different trackers,
 * copies too, are independent.
 *
 * Instantiated for PointXYZ, PointXYZI, PointXYZRGB, PointXYZRGBA and
 * PointXYZRGBNormal; for other types, and with flags such as -march=native, as
 * PiecewiseRigidRegistration.
 */
template <typename PointT>
class PiecewiseRigidTracker : public SceneFlowSettings {
public:
  PiecewiseRigidTracker() : SceneFlowSettings ("PiecewiseRigidTracker") {}

  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;

  /** \brief Window and rules, see TrackerParameters; takes effect at the next restart.
   * Bad values are refused with a PCL_ERROR. */
  void
  setTrackerParameters (const TrackerParameters& parameters);
  TrackerParameters
  getTrackerParameters () const
  {
    return parameters_;
  }

  /** \brief How Eq. 5 is minimized; `max_seconds` is for each cloud. */
  void
  setSolverParameters (const SolverParameters& parameters)
  {
    takeSolverParameters (parameters, "setSolverParameters");
  }
  SolverParameters
  getSolverParameters () const
  {
    return solver_;
  }

  /** \brief Takes the next cloud. \return false, with a PCL_ERROR, when it cannot be
   * used; then everything is as before. The first one only starts the window. Whether a
   * later one's motion is known says getSceneFlow ().report.converged. */
  bool
  addCloud (const PointCloudConstPtr& cloud);

  /** \brief Forgets all clouds; the next one is the first. */
  void
  restart ();

  /** \brief The motion from getReferenceCloud to the newest cloud; empty before the
   * second one. */
  const SceneFlow&
  getSceneFlow () const
  {
    return tracker_.sceneFlow();
  }
  /** \brief The whole window; frame 0 is its reference. */
  const MultiframeSceneFlow&
  getMultiframeSceneFlow () const
  {
    return tracker_.result();
  }

  /** \brief A copy of the window's reference, its oldest cloud; null before the first
   * one. */
  PointCloudConstPtr
  getReferenceCloud () const
  {
    return reference_;
  }

  /** \brief The reference carried to the newest cloud, organized; NaN where the motion
   * is unknown; normals turn with their segments; other fields, header and sensor pose
   * are the reference's. Empty before the second cloud. */
  PointCloud
  getWarpedCloud () const;

  /** \brief Camera pose of the newest cloud, `world_from_camera`; the world is the
   * first cloud's camera. Visual odometry, when the dominant motion is the static
   * scene's. */
  Eigen::Matrix<float, 4, 4>
  getCameraPose () const
  {
    return tracker_.cameraPose().matrix();
  }

  /** \brief How many clouds were given before the reference. */
  long
  getReferenceIndex () const
  {
    return tracker_.firstFrame();
  }

private:
  TrackerParameters parameters_;
  PinholeCamera used_camera_;
  double intensity_unit_{0.0}; ///< of the clouds so far; it can only grow
  SceneFlowTracker tracker_;
  PointCloudConstPtr reference_;
  PointCloudConstPtr newest_; ///< the next reference when the present one is given up
};

} // namespace pcl_msf

#include <pcl_msf/impl/piecewise_rigid_tracker.hpp>

#if !defined(PCL_NO_PRECOMPILE) && PCL_MSF_SAME_LAYOUT
namespace pcl_msf {
extern template class PCL_MSF_EXPORT PiecewiseRigidTracker<pcl::PointXYZ>;
extern template class PCL_MSF_EXPORT PiecewiseRigidTracker<pcl::PointXYZI>;
extern template class PCL_MSF_EXPORT PiecewiseRigidTracker<pcl::PointXYZRGB>;
extern template class PCL_MSF_EXPORT PiecewiseRigidTracker<pcl::PointXYZRGBA>;
extern template class PCL_MSF_EXPORT PiecewiseRigidTracker<pcl::PointXYZRGBNormal>;
} // namespace pcl_msf
#endif
