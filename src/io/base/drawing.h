// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>

#include <string>

namespace pcl_msf::io {

/** \brief An image as BGR; plain grey of the given size when it is empty. A copy. */
PCL_MSF_EXPORT cv::Mat
asBgr (const cv::Mat& image, const cv::Size& size);

/** \brief An image as CV_8UC1. */
PCL_MSF_EXPORT cv::Mat
asGray (const cv::Mat& image);

/** \brief Writes text in dark or light letters of about `height` pixels.
 * \param origin left end of the base line \return width of the text, pixels */
PCL_MSF_EXPORT int
drawText (cv::Mat& picture,
          const std::string& text,
          const cv::Point& origin,
          int height,
          const cv::Scalar& color);

/** \brief Width that `drawText` would take, pixels. */
PCL_MSF_EXPORT int
textWidth (const std::string& text, int height);

/** \brief A number for a person: three significant digits. */
PCL_MSF_EXPORT std::string
shortNumber (double number);

} // namespace pcl_msf::io
