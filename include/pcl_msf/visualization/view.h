// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/pinhole_camera.h>

namespace pcl_msf::visualization {

/** \brief Where a picture is taken from: a pinhole camera at a pose, or a parallel one.
 *
 * Perspective: `camera` has the pixels of `size`, so a point lands on the pixel that
 * PinholeCamera::project gives. Parallel: a point (x, y, z) of the view's frame lands
 * on (scale x + cx, scale y + cy) with the camera's cx and cy. Frames are optical ones:
 * x right, y down, z forward.
 */
struct PCL_MSF_EXPORT View {
  Eigen::Matrix3d rotation{Eigen::Matrix3d::Identity()}; ///< view_from_scene
  Eigen::Vector3d position{Eigen::Vector3d::Zero()};     ///< of the eye, scene, metres
  PinholeCamera camera;
  cv::Size size;
  bool parallel{false};
  double scale{0.0}; ///< parallel: pixels per metre, > 0

  /** \brief A scene point in the view's frame, metres. */
  Eigen::Vector3d
  toView (const Eigen::Vector3d& point) const
  {
    return rotation * (point - position);
  }

  /** \brief The pixel of a scene point; NaN behind a perspective eye. */
  Eigen::Vector2d
  project (const Eigen::Vector3d& point) const;

  /** \brief The same view in a picture of another size: the whole of it is seen,
   * centred, with more around it where the shapes differ. */
  View
  resized (const cv::Size& picture) const;
};

/** \brief The part of space that a scene fills, outliers left out. */
struct SceneBounds {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()}; ///< metres
  double radius{1.0};                              ///< metres, > 0
  double distance{1.0};                            ///< centre to the scene's origin
};

/** \brief Bounds between the 2nd and 98th percentile of each axis.
 * \param points CV_32FC3, metres; NaN is left out */
PCL_MSF_EXPORT SceneBounds
boundsOf (const cv::Mat& points);

/** \brief What the sensor sees. \param size of its images, pixels */
PCL_MSF_EXPORT View
sensorView (const PinholeCamera& camera, const cv::Size& size);

/** \brief Looks at the scene's centre from where the sensor is, turned around it.
 * \param azimuth to the right, degrees \param elevation upwards, degrees, [-89, 89]
 * \param field_of_view along the larger side, degrees, (1, 170)
 * \param zoom 1 = the scene fills the picture; larger = nearer */
PCL_MSF_EXPORT View
orbitView (const SceneBounds& bounds,
           const cv::Size& size,
           double azimuth,
           double elevation,
           double field_of_view = 45.0,
           double zoom = 1.0);

/** \brief Looks straight down, the sensor's viewing direction pointing up. */
PCL_MSF_EXPORT View
topView (const SceneBounds& bounds,
         const cv::Size& size,
         double field_of_view = 45.0,
         double zoom = 1.0);

/** \brief Looks from a point to another. \param up any direction that is not along the
 * line of sight; scene frame, e.g. (0, -1, 0) \throws InvalidInput when it is along it
 * or both points are one */
PCL_MSF_EXPORT View
userView (const Eigen::Vector3d& eye,
          const Eigen::Vector3d& target,
          const Eigen::Vector3d& up,
          const cv::Size& size,
          double field_of_view = 45.0);

/** \brief The parallel view of the same direction that shows the points at `distance`
 * metres from the eye at the same size. */
PCL_MSF_EXPORT View
parallelView (const View& perspective, double distance);

} // namespace pcl_msf::visualization
