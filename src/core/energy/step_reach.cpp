// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/step_reach.h"

#include <Eigen/Cholesky>

#include "core/base/flatten.h"
#include "core/motion/motion_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_msf {

namespace {

constexpr int kTries = 4;           // Newton steps towards the damping
constexpr double kNear = 1.05;      // of the reach: near enough
constexpr double kThickness = 0.01; // of a body's squared extent, where it has none

} // namespace

StepReach::StepReach (std::vector<BodyShape> shapes,
                      double focal_length,
                      const StepTuning& tuning)
: shapes_ (std::move (shapes))
, focal_length_ (focal_length)
, tuning_ (tuning)
, pixels_ (shapes_.size(), tuning.reach)
{}

/** M, with d' M d the mean squared motion of the body's points when the pose parameters
 * change by d; pixels. */
PCL_MSF_FLATTEN Matrix6
StepReach::squaredMotion (int body, const RigidPose& pose) const
{
  const Eigen::Matrix3d rotation = pose.rotation();
  const Eigen::Vector3d arm = rotation * shapes_[body].center;
  const double z = std::max (arm.z() + pose.translation().z(), 1e-3);
  const Eigen::Matrix3d spread = rotation * shapes_[body].spread;
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d moment = spread * spread.transpose();
  const double extent = moment.trace();
  const Eigen::Matrix3d turn =
      leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]});
  const Eigen::Matrix3d carry = -skew (arm) * turn;
  const Eigen::Matrix3d about = (extent + kThickness * (extent + z * z * 1e-6)) * one;
  Matrix6 m;
  m.topLeftCorner<3, 3>() =
      turn.transpose() * (about - moment) * turn + carry.transpose() * carry;
  m.topRightCorner<3, 3>() = carry.transpose();
  m.bottomLeftCorner<3, 3>() = carry;
  m.bottomRightCorner<3, 3>() = one;
  return std::pow (focal_length_ / z, 2) * m;
}

/** Newton's method on 1 / |step| = 1 / reach, from the side of too little damping. */
PCL_MSF_FLATTEN void
StepReach::damp (int body,
                 const RigidPose& pose,
                 const Vector6& gradient,
                 Matrix6& information) const
{
  if (!(information.trace() > 0.0) || !information.allFinite())
    return;
  const double reach = pixels_[body];
  const Matrix6 m = squaredMotion (body, pose);
  double lambda = 1e-9 * information.trace() / m.trace();
  for (int i = 0; i < kTries; ++i) {
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> llt (information + lambda * m);
    const Vector6 step = llt.solve (gradient);
    const Vector6 moved = m * step;
    const double length = std::sqrt (step.dot (moved));
    if (llt.info() != Eigen::Success || !std::isfinite (length)) {
      lambda *= 10.0;
      continue;
    }
    if (length <= kNear * reach)
      break;
    const double slope = moved.dot (llt.solve (moved)) / (length * length);
    lambda += (length / reach - 1.0) / std::max (slope, 1e-300);
  }
  information += lambda * m;
}

void
StepReach::learn (int body, bool gained)
{
  pixels_[body] = std::clamp (pixels_[body] * (gained ? tuning_.grow : tuning_.shrink),
                              tuning_.least * tuning_.reach,
                              tuning_.reach);
}

} // namespace pcl_msf
