// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include "core/base/flatten.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/evaluation/trajectory_errors.h>

#include <cmath>
#include <limits>
#include <string>

namespace pcl_msf::evaluation {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Eigen::Matrix3Xd
positions (const std::vector<RigidPose>& poses)
{
  Eigen::Matrix3Xd result (3, static_cast<Eigen::Index> (poses.size()));
  for (std::size_t k = 0; k < poses.size(); ++k)
    result.col (static_cast<Eigen::Index> (k)) = poses[k].translation();
  return result;
}

void
requireSameNumber (const std::vector<RigidPose>& estimate,
                   const std::vector<RigidPose>& truth)
{
  if (estimate.size() != truth.size())
    throw InvalidInput ("trajectories: " + std::to_string (estimate.size()) +
                        " estimated and " + std::to_string (truth.size()) +
                        " true poses; give one of each per time");
}

} // namespace

std::vector<RigidPose>
chainMotions (const std::vector<RigidPose>& motions)
{
  std::vector<RigidPose> poses (1);
  for (const RigidPose& motion : motions)
    poses.push_back (poses.back() * motion.inverse());
  return poses;
}

PCL_MSF_FLATTEN double // see fit in pose_errors.cpp
absoluteTrajectoryError (const std::vector<RigidPose>& estimate,
                         const std::vector<RigidPose>& truth)
{
  requireSameNumber (estimate, truth);
  if (estimate.size() < 2)
    return kNan;
  const Eigen::Matrix3Xd from = positions (estimate), to = positions (truth);
  const Eigen::Matrix4d align = Eigen::umeyama (from, to, false);
  const Eigen::Matrix3Xd aligned = (align.topLeftCorner<3, 3>() * from).colwise() +
                                   Eigen::Vector3d (align.topRightCorner<3, 1>());
  return std::sqrt ((aligned - to).colwise().squaredNorm().mean());
}

RelativePoseError
relativePoseError (const std::vector<RigidPose>& estimate,
                   const std::vector<RigidPose>& truth,
                   int delta)
{
  requireSameNumber (estimate, truth);
  if (delta < 1)
    throw InvalidInput ("relative pose error: delta must be >= 1");
  const auto step = static_cast<std::size_t> (delta);
  if (estimate.size() <= step)
    return {kNan, kNan};
  double translation = 0.0, rotation = 0.0;
  const std::size_t n = estimate.size() - step;
  for (std::size_t i = 0; i < n; ++i) {
    const RigidPose moved = estimate[i].inverse() * estimate[i + step];
    const RigidPose expected = truth[i].inverse() * truth[i + step];
    const RigidPose error = expected.inverse() * moved;
    translation += error.translation().squaredNorm();
    rotation += error.angle() * error.angle();
  }
  return {std::sqrt (translation / static_cast<double> (n)),
          std::sqrt (rotation / static_cast<double> (n)) * 180.0 / M_PI};
}

} // namespace pcl_msf::evaluation
