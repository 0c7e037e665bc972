// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuning.h"
#include "core/surface/surface_texture.h"
#include <pcl_msf/rigid_pose.h>

#include <string>
#include <vector>

namespace pcl_msf {

/** \brief The points of one cloud that a registration works on. */
struct WorkingCloud {
  Surface surface;             ///< scaled
  std::vector<int> given;      ///< per working point, its index in the cloud
  std::vector<int> samples;    ///< of the surface, evenly spread
  std::vector<int> segment;    ///< per working point, of given ones: 0, 1, .. without
                               ///< gaps; empty = none are given
  Surface thin;                ///< of the samples alone
  SurfaceTexture texture;      ///< of the surface; see addTextures
  SurfaceTexture thin_texture; ///< and of the thin one
};

/** \brief Both clouds, brought to a size of about 1 around the origin: whatever unit
 * they came in, the same numbers go through the solver. */
struct PointClouds {
  WorkingCloud source;
  WorkingCloud target;
  Eigen::Vector3d center{Eigen::Vector3d::Zero()}; ///< of the source, as given
  double size{1.0};                                ///< of the source, as given

  Eigen::Vector3f
  scaled (const Eigen::Vector3f& point) const
  {
    return ((point.cast<double>() - center) / size).cast<float>();
  }
  Eigen::Vector3f
  asGiven (const Eigen::Vector3f& point) const
  {
    return (size * point.cast<double>() + center).cast<float>();
  }
  /** \brief A motion of scaled points as one of points as given. */
  RigidPose
  asGiven (const RigidPose& pose) const;
  RigidPose
  scaled (const RigidPose& pose) const;
};

/** \brief The points of a cloud as they came in, and their normals. Both must outlive
 * it. */
struct InputPoints {
  /** \param given_normals per point, as surfaceNormals takes given ones */
  InputPoints (const std::vector<Eigen::Vector3f>& given_points,
               const std::vector<Eigen::Vector3f>& given_normals = none())
  : points (given_points), normals (given_normals)
  {}

  static const std::vector<Eigen::Vector3f>&
  none ();

  const std::vector<Eigen::Vector3f>& points;
  const std::vector<Eigen::Vector3f>& normals;
};

/** \brief Could a camera in the origin have seen the point? It sees 127 degrees from
 * side to side. \param point as given; not finite = no */
inline bool
isInCameraView (const Eigen::Vector3f& point)
{
  constexpr float widest = 2.0f; // x or y by z
  return point.head<2>().cwiseAbs().maxCoeff() < widest * point.z();
}

/** \brief Prepares two clouds: without points that are not finite, doubled or off every
 * surface, and at most as many as are of use.
 * \param segments given ones, per source point; -1 = it takes no part; empty = none are
 * given
 * \param name of the target, in messages
 * \throws InvalidInput naming the remedy when too few remain */
PointClouds
preparePointClouds (const InputPoints& source,
                    const InputPoints& target,
                    const Tuning& tuning,
                    int threads,
                    const std::vector<int>& segments = {},
                    const std::string& name = "target");

/** \brief The same source with another target.
 * \param name of the target, in messages
 * \throws InvalidInput naming the remedy when too few of its points remain */
PointClouds
withTarget (const PointClouds& clouds,
            const InputPoints& target,
            const std::string& name,
            const Tuning& tuning,
            int threads);

} // namespace pcl_msf
