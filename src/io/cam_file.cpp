// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/output_file.h"
#include "io/tagged_floats.h"
#include <pcl_msf/io/float_files.h>

#include <array>
#include <cstring>

namespace pcl_msf::io {

void
writeCam (const std::string& path,
          const PinholeCamera& camera,
          const RigidPose& camera_from_world)
{
  std::array<double, 21> numbers = {
      camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  const Eigen::Matrix3d rotation = camera_from_world.rotation();
  const Eigen::Vector3d translation = camera_from_world.translation();
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col)
      numbers[9 + 4 * row + col] = rotation (row, col);
    numbers[12 + 4 * row] = translation[row];
  }
  std::array<unsigned char, sizeof (kFloatTag) + sizeof (numbers)> bytes{};
  std::memcpy (bytes.data(), &kFloatTag, sizeof (kFloatTag));
  std::memcpy (bytes.data() + sizeof (kFloatTag), numbers.data(), sizeof (numbers));
  writeBytes (path, bytes.data(), bytes.size());
}

} // namespace pcl_msf::io
