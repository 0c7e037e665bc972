// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/base/output_file.h"
#include "io/base/rotation_check.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/text_files.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <vector>

namespace pcl_msf::io {

namespace {

/** Numbers of a text file in the order of their names; behind the first `needed` ones
 * the file may end. */
template <std::size_t N>
std::vector<double>
readNumbers (const std::string& path,
             const std::array<const char*, N>& names,
             std::size_t needed = N)
{
  InputFile file (path);
  std::istringstream words (file.text());
  std::vector<double> numbers (N);
  for (std::size_t i = 0; i < N; ++i) {
    std::string word;
    if (!(words >> word)) {
      if (i >= needed) {
        numbers.resize (i);
        return numbers;
      }
      file.fail (names[i],
                 "missing; " + std::to_string (needed) + " numbers are needed");
    }
    if (!parseNumber (word, numbers[i]) || !std::isfinite (numbers[i]))
      file.fail (names[i],
                 "'" + word + "' is no finite number; write " +
                     std::to_string (needed) + " numbers with blanks between");
  }
  std::string rest;
  if (words >> rest)
    file.fail ("end", "'" + rest + "' follows where nothing should; remove it");
  return numbers;
}

int
imageSide (const std::string& path, const char* name, double value)
{
  if (value != std::floor (value) || value < 1.0 || value > 1e6)
    throw IoError (path + ": " + name + ": " + generalText (value) +
                   ", must be a whole number of pixels, 1 or more");
  return static_cast<int> (value);
}

/** A line of numbers that read back exactly. */
std::string
exactLine (std::initializer_list<double> numbers)
{
  std::string line;
  for (const double number : numbers)
    line += (line.empty() ? "" : " ") + generalText (number, 17);
  return line + '\n';
}

} // namespace

void
writeText (const std::string& path, const std::string& text)
{
  writeBytes (path, text.data(), text.size());
}

CameraFile
readCamera (const std::string& path)
{
  const auto n = readNumbers<12> (path,
                                  {"fx",
                                   "fy",
                                   "cx",
                                   "cy",
                                   "width",
                                   "height",
                                   "depth_scale",
                                   "k1",
                                   "k2",
                                   "p1",
                                   "p2",
                                   "k3"},
                                  7);
  if (n.size() > 7 && n.size() < 11)
    throw IoError (path + ": k1 k2 p1 p2: " + std::to_string (n.size() - 7) +
                   " of the distortion's numbers; give four or five, or none");
  CameraFile file;
  file.camera = {n[0], n[1], n[2], n[3]};
  file.width = imageSide (path, "width", n[4]);
  file.height = imageSide (path, "height", n[5]);
  file.depth_scale = n[6];
  checkImageSize (path, file.width, file.height);
  std::string why;
  if (!file.camera.isValid (file.width, file.height, &why))
    throw IoError (path + ": fx fy cx cy: " + why);
  if (file.depth_scale <= 0.0)
    throw IoError (path + ": depth_scale: " + generalText (file.depth_scale) +
                   ", must be > 0; give units per metre, for example 1000");
  if (n.size() > 7)
    file.distortion = {n[7], n[8], n[9], n[10], n.size() > 11 ? n[11] : 0.0};
  if (!file.distortion.isValid (file.camera, file.width, file.height, &why))
    throw IoError (path + ": k1 k2 p1 p2: " + why);
  return file;
}

void
writeCamera (const std::string& path, const CameraFile& file)
{
  const PinholeCamera& c = file.camera;
  const LensDistortion& l = file.distortion;
  const double width = file.width, height = file.height, scale = file.depth_scale;
  if (l.isNone())
    writeText (path, exactLine ({c.fx, c.fy, c.cx, c.cy, width, height, scale}));
  else
    writeText (path,
               exactLine ({c.fx,
                           c.fy,
                           c.cx,
                           c.cy,
                           width,
                           height,
                           scale,
                           l.k1,
                           l.k2,
                           l.p1,
                           l.p2,
                           l.k3}));
}

RigidPose
readPose (const std::string& path)
{
  const auto n = readNumbers<16> (path,
                                  {"m00",
                                   "m01",
                                   "m02",
                                   "m03",
                                   "m10",
                                   "m11",
                                   "m12",
                                   "m13",
                                   "m20",
                                   "m21",
                                   "m22",
                                   "m23",
                                   "m30",
                                   "m31",
                                   "m32",
                                   "m33"});
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix (
      n.data());
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const bool last_row_ok = n[12] == 0.0 && n[13] == 0.0 && n[14] == 0.0 && n[15] == 1.0;
  if (!isRotation (rotation) || !last_row_ok)
    throw IoError (path + ": matrix: no rigid motion; give rotation, translation and "
                          "the last row 0 0 0 1");
  return RigidPose::fromMatrix (rotation, matrix.topRightCorner<3, 1>());
}

void
writePose (const std::string& path, const RigidPose& pose)
{
  std::string text;
  const Eigen::Matrix3d rotation = pose.rotation();
  const Eigen::Vector3d translation = pose.translation();
  for (int row = 0; row < 3; ++row)
    text += exactLine (
        {rotation (row, 0), rotation (row, 1), rotation (row, 2), translation[row]});
  writeText (path, text + "0 0 0 1\n");
}

} // namespace pcl_msf::io
