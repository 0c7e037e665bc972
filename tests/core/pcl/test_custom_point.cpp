// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#define PCL_NO_PRECOMPILE
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <pcl_msf/piecewise_rigid_registration.h>

/** A user's point: 16-bit brightness, and a field of the user's own. */
struct SensorPoint {
  PCL_ADD_POINT4D;
  std::uint16_t intensity;
  std::uint32_t stamp;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT (SensorPoint,
                                   (float, x, x) (float, y, y) (float, z, z) //
                                   (std::uint16_t, intensity, intensity)     //
                                   (std::uint32_t, stamp, stamp))

namespace {

using namespace pcl_msf;

pcl::PointCloud<SensorPoint>::Ptr
sensorCloud (const RigidPair::Cloud& from)
{
  const auto cloud =
      pcl::make_shared<pcl::PointCloud<SensorPoint>> (from.width, from.height);
  for (std::size_t i = 0; i < from.size(); ++i) {
    auto& p = (*cloud)[i];
    p.getVector3fMap() = from[i].getVector3fMap();
    p.intensity = static_cast<std::uint16_t> (257 * from[i].g);
    p.stamp = static_cast<std::uint32_t> (i);
  }
  return cloud;
}

TEST (CustomPoint, IsAlignedAndKeepsItsOwnFields)
{
  const auto reference = RigidPair::reference();
  PiecewiseRigidRegistration<SensorPoint> registration;
  registration.setInputSource (sensorCloud (*reference));
  registration.setInputTarget (sensorCloud (*RigidPair::current()));
  pcl::PointCloud<SensorPoint> warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged());
  EXPECT_EQ (warped (30, 20).stamp, 20u * RigidPair::kWidth + 30u);
  EXPECT_TRUE (registration.getFinalTransformation().isApprox (
      RigidPair::motion().matrix(), 0.01f));
  pcl::Registration<SensorPoint, SensorPoint>& base = registration;
  EXPECT_LT (base.getFitnessScore(), 1e-3);
}

} // namespace
