// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/pinhole_camera.h>

int
main ()
{
  const pcl_msf::PinholeCamera camera{525.0, 525.0, 319.5, 239.5};
  return camera.isValid (640, 480) ? 0 : 1;
}
