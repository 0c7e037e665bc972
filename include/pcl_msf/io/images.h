// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_images.h>

#include <string>

namespace pcl_msf::io {

/** \brief Reads a colour or grey image of any format that OpenCV reads.
 *
 * Alpha is dropped, 16 bit become 8; a camera's orientation tag is ignored, because the
 * depth image is registered to the pixels as they are stored.
 * \return CV_8UC1 or CV_8UC3 (BGR) \throws IoError */
PCL_MSF_EXPORT cv::Mat
readColor (const std::string& path);

/** \brief Reads a frame's colour into `color`, as above, and 16-bit grey (infrared and
 * ToF cameras, which fill any part of the range) into `raw_color`, too. \throws IoError
 */
PCL_MSF_EXPORT void
readColor (const std::string& path, RgbdImages& images);

/** \brief Reads a depth image.
 *
 * One-channel 16-bit integers (.png, .tiff, .pgm) are divided by `depth_scale`; floats
 * (.dpt, .pfm, .tiff, .exr) are metres unless `float_scale` says otherwise.
 * \param depth_scale integer units per metre, > 0, e.g. 1000 for millimetres
 * \param float_scale float units per metre, > 0
 * \return CV_32FC1, metres; 0, NaN, inf or negative = no measurement, as in the file. A
 * saturated integer, 65535, is none either and becomes 0
 * \throws IoError */
PCL_MSF_EXPORT cv::Mat
readDepth (const std::string& path, double depth_scale, double float_scale = 1.0);

/** \brief Writes a 16-bit depth PNG. \param depth CV_32FC1, metres; what is no
 * measurement or does not fit into 16 bit, less than 65535, is written as 0 \throws
 * IoError */
PCL_MSF_EXPORT void
writeDepth (const std::string& path, const cv::Mat& depth, double depth_scale);

/** \brief Reads a label image, 8 or 16 bit, one channel.
 * \return CV_32SC1; 65535 in a 16-bit image comes back as -1 = no segment
 * \throws IoError */
PCL_MSF_EXPORT cv::Mat
readLabels (const std::string& path);

/** \brief Writes a 16-bit label PNG. \param labels CV_32SC1, 0 .. 65534 as they are,
 * negative (no segment) as 65535 \throws IoError, also for larger labels */
PCL_MSF_EXPORT void
writeLabels (const std::string& path, const cv::Mat& labels);

/** \brief Reads a mask. \return CV_8UC1, 255 where the file is not 0 \throws IoError */
PCL_MSF_EXPORT cv::Mat
readMask (const std::string& path);

/** \brief Reads an image of any format that OpenCV knows, as it is in the file.
 * \return not empty; colours as BGR or BGRA \throws IoError */
PCL_MSF_EXPORT cv::Mat
readImage (const std::string& path);

/** \brief Writes a picture in the format of the path's extension.
 * \param image CV_8UC1, CV_8UC3 (BGR) or CV_16UC1 \throws IoError */
PCL_MSF_EXPORT void
writeImage (const std::string& path, const cv::Mat& image);

} // namespace pcl_msf::io
