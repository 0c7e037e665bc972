// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include <pcl_msf/rigid_pose.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>

// Files in the published byte layouts, written without any of the library's code.
namespace pcl_msf::testing {

inline void
makeFoldersFor (const std::string& file)
{
  std::filesystem::create_directories (std::filesystem::path (file).parent_path());
}

template <typename T>
void
append (std::string& bytes, const T& value)
{
  const std::size_t at = bytes.size();
  bytes.resize (at + sizeof (T));
  std::memcpy (&bytes[at], &value, sizeof (T));
}

/** \brief Text, made with the folders above it. */
inline void
putText (const std::string& path, const std::string& text)
{
  makeFoldersFor (path);
  writeFile (path, text);
}

/** \brief PNG, PPM, PGM or JPEG. */
inline void
putImage (const std::string& path, const cv::Mat& image)
{
  makeFoldersFor (path);
  if (!cv::imwrite (path, image))
    throw std::runtime_error ("cannot write " + path);
}

/** \brief .dpt (one channel) or .flo (two): "PIEH", width, height, floats. */
inline void
putTagged (const std::string& path, const cv::Mat& image)
{
  std::string bytes = "PIEH";
  append (bytes, std::int32_t{image.cols});
  append (bytes, std::int32_t{image.rows});
  for (int row = 0; row < image.rows; ++row)
    bytes.append (image.ptr<char> (row), image.cols * image.elemSize());
  putText (path, bytes);
}

/** \brief Little-endian .pfm, bottom row first. */
inline void
putPfm (const std::string& path, const cv::Mat& image)
{
  std::ostringstream header;
  header << (image.channels() == 3 ? "PF" : "Pf") << '\n'
         << image.cols << ' ' << image.rows << "\n-1.000000\n";
  std::string bytes = header.str();
  for (int row = image.rows - 1; row >= 0; --row)
    bytes.append (image.ptr<char> (row), image.cols * image.elemSize());
  putText (path, bytes);
}

/** \brief The upper 3x4 of a pose by rows, and a last row 0 0 0 1 when asked for. */
inline std::string
matrixText (const RigidPose& pose, bool last_row)
{
  std::ostringstream text;
  text << std::setprecision (12);
  const Eigen::Matrix3d r = pose.rotation();
  const Eigen::Vector3d t = pose.translation();
  for (int i = 0; i < 3; ++i)
    text << r (i, 0) << ' ' << r (i, 1) << ' ' << r (i, 2) << ' ' << t[i]
         << (i < 2 ? " " : "");
  if (last_row)
    text << " 0 0 0 1";
  return text.str();
}

inline std::string
numbered (const std::string& stem, int number, int digits, const std::string& end)
{
  std::ostringstream name;
  name << stem << std::setw (digits) << std::setfill ('0') << number << end;
  return name.str();
}

/** \brief 16-bit units of a float image; 0 where it is not finite. */
inline cv::Mat
units (const cv::Mat& image, double per_unit)
{
  cv::Mat result (image.size(), CV_16UC1, cv::Scalar (0));
  for (int row = 0; row < image.rows; ++row)
    for (int col = 0; col < image.cols; ++col) {
      const double value = std::round (image.at<float> (row, col) * per_unit);
      if (value > 0.0 && value < 65535.5)
        result.at<std::uint16_t> (row, col) = static_cast<std::uint16_t> (value);
    }
  return result;
}

} // namespace pcl_msf::testing
