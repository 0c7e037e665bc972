// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/io/rgbd_sequence.h>

#include <limits>

namespace pcl_msf::io {

double
RgbdSequence::timestamp (int) const
{
  return std::numeric_limits<double>::quiet_NaN();
}

MotionTruth
RgbdSequence::truth (int, int) const
{
  return {};
}

std::optional<RigidPose>
RgbdSequence::cameraPose (int) const
{
  return std::nullopt;
}

bool
RgbdSequence::definesDepthUnit() const
{
  return false;
}

} // namespace pcl_msf::io
