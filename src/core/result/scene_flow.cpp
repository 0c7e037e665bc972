// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/scene_flow.h>

#include <limits>

namespace pcl_msf {

const char*
toString (StopReason reason)
{
  switch (reason) {
  case StopReason::NotRun:
    return "not_run";
  case StopReason::Converged:
    return "converged";
  case StopReason::IterationLimit:
    return "iteration_limit";
  case StopReason::TimeLimit:
    return "time_limit";
  case StopReason::Cancelled:
    return "cancelled";
  case StopReason::InvalidInput:
    return "invalid_input";
  case StopReason::NumericalFailure:
    return "numerical_failure";
  case StopReason::NothingDetermined:
    return "nothing_determined";
  case StopReason::DifferentPlaces:
    return "different_places";
  }
  return "unknown";
}

Eigen::Vector3d
SceneFlow::warp (const Eigen::Vector3d& point, int label) const
{
  const bool known = label >= 0 && label < static_cast<int> (segments.size()) &&
                     segments[label].status != MotionStatus::Undetermined;
  if (!known)
    return Eigen::Vector3d::Constant (std::numeric_limits<double>::quiet_NaN());
  return segments[label].current_from_reference * point;
}

} // namespace pcl_msf
