// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/memory.h>
#include <pcl/pcl_macros.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdint>

namespace pcl_msf {

/** \brief A point of the reference with its scene flow, as written to .pcd files.
 *
 * x y z: metres, reference camera frame, NaN = no depth. dx dy dz: displacement to the
 * current frame, metres, NaN = unknown. label: segment, kNoLabel = none. visible: 255 =
 * seen in both frames, 0 = not. flow_deviation (pixels), displacement_deviation
 * (metres): standard deviations of the errors, see SceneFlow; NaN = unknown.
 */
struct EIGEN_ALIGN16 PointXYZRGBFlow {
  static constexpr std::uint32_t kNoLabel = 0xFFFFFFFFU;

  PCL_ADD_POINT4D
  PCL_ADD_RGB
  float dx;
  float dy;
  float dz;
  std::uint32_t label;
  std::uint8_t visible;
  float flow_deviation;
  float displacement_deviation;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace pcl_msf

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT (pcl_msf::PointXYZRGBFlow,
                                   (float, x, x)
                                   (float, y, y)
                                   (float, z, z)
                                   (float, rgb, rgb)
                                   (float, dx, dx)
                                   (float, dy, dy)
                                   (float, dz, dz)
                                   (std::uint32_t, label, label)
                                   (std::uint8_t, visible, visible)
                                   (float, flow_deviation, flow_deviation)
                                   (float,
                                    displacement_deviation,
                                    displacement_deviation))
// clang-format on
