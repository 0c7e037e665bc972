// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#define PCL_NO_PRECOMPILE
#include "wavy_pair.h"

struct EIGEN_ALIGN16 OwnPoint {
  PCL_ADD_POINT4D
  std::uint16_t ring;
  double stamp;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT (OwnPoint,
                                   (float, x, x)
                                   (float, y, y)
                                   (float, z, z)
                                   (std::uint16_t, ring, ring)
                                   (double, stamp, stamp))
// clang-format on

int
main ()
{
  return registers<OwnPoint>() ? 0 : 1;
}
