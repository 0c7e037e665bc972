// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/LU>

#include "io/base/input_file.h"
#include "io/base/output_file.h"
#include "io/base/rotation_check.h"
#include "io/formats/tagged_floats.h"
#include <pcl_msf/io/float_files.h>

#include <array>
#include <cmath>
#include <cstring>

namespace pcl_msf::io {

PinholeCamera
readCam (const std::string& path, RigidPose& camera_from_world)
{
  InputFile file (path);
  if (file.value<float> ("magic number") != kFloatTag)
    file.fail ("magic number", "not 202021.25; the file is of another format");
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> intrinsic;
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> extrinsic;
  file.read (intrinsic.data(), sizeof (double) * 9, "intrinsic matrix");
  file.read (extrinsic.data(), sizeof (double) * 12, "extrinsic matrix");
  if (file.remaining() != 0)
    file.fail ("end", "more bytes than two matrices have; the file is damaged");
  const Eigen::RowVector3d last = intrinsic.row (2);
  const bool pinhole = intrinsic.allFinite() && last == Eigen::RowVector3d (0, 0, 1) &&
                       intrinsic (1, 0) == 0.0 && std::abs (intrinsic (0, 1)) < 1e-6 &&
                       intrinsic (0, 0) > 0.0 && intrinsic (1, 1) > 0.0;
  if (!pinhole)
    file.fail ("intrinsic matrix", "no pinhole camera; the file is damaged");
  const Eigen::Matrix3d rotation = extrinsic.leftCols<3>();
  if (!extrinsic.allFinite() || !isRotation (rotation))
    file.fail ("extrinsic matrix", "no rigid motion; the file is damaged");
  camera_from_world = RigidPose::fromMatrix (rotation, extrinsic.col (3));
  return {intrinsic (0, 0), intrinsic (1, 1), intrinsic (0, 2), intrinsic (1, 2)};
}

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
