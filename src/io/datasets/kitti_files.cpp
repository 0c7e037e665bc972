// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/kitti_files.h"

#include "core/base/number_text.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/text_table.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>

#include <array>
#include <limits>

namespace pcl_msf::io {

namespace {

using Projection = std::array<double, 12>;

/** A 3x4 matrix, row by row, of the line that begins with its name and a colon. */
Projection
projectionNamed (const TextTable& table, const std::string& path, const char* name)
{
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.word (row, 0, name) != std::string (name) + ":")
      continue;
    Projection matrix{};
    for (std::size_t i = 0; i < matrix.size(); ++i)
      matrix[i] = table.number (row, i + 1, name);
    return matrix;
  }
  throw IoError (path + ": " + name + ": missing; give the file of the data set");
}

} // namespace

KittiCamera
readKittiCamera (const std::string& path)
{
  const TextTable table (path);
  const Projection left = projectionNamed (table, path, "P_rect_02");
  const Projection right = projectionNamed (table, path, "P_rect_03");
  KittiCamera result{{left[0], left[5], left[2], left[6]}, 0.0};
  if (!(left[0] > 0.0) || !(left[5] > 0.0))
    throw IoError (path + ": P_rect_02: no camera, for its focal length is " +
                   generalText (left[0]) + ", " + generalText (left[5]) +
                   "; give the file of the data set");
  result.baseline = (left[3] - right[3]) / left[0];
  if (!(result.baseline > 0.0))
    throw IoError (path + ": P_rect_03: " + generalText (result.baseline) +
                   " m to the right of P_rect_02, must be > 0; give the file of the "
                   "data set");
  return result;
}

cv::Mat
readKittiDisparity (const std::string& path)
{
  return readDepth (path, 256.0);
}

cv::Mat
readKittiFlow (const std::string& path)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat image = readDeepColor (path, "flow");
  cv::Mat flow (image.size(), CV_32FC2, cv::Scalar (nan, nan));
  for (int row = 0; row < image.rows; ++row)
    for (int col = 0; col < image.cols; ++col) {
      const auto bgr = image.at<cv::Vec3w> (row, col);
      if (bgr[0] != 0)
        flow.at<cv::Vec2f> (row,
                            col) = {(static_cast<float> (bgr[2]) - 32768.0F) / 64.0F,
                                    (static_cast<float> (bgr[1]) - 32768.0F) / 64.0F};
    }
  return flow;
}

} // namespace pcl_msf::io
