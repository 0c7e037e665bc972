// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <string>

namespace pcl_msf::visualization {

/** \brief Text as coverage, CV_8UC1, trimmed in width; every text of one height has as
 * many rows and the same base line. \param height of a line, pixels */
cv::Mat
textMask (const std::string& text, int height, bool bold = false);

/** \brief Draws text into a picture (CV_8UC3); what is outside is left out.
 * \param corner upper left of the line \return its width, pixels */
int
drawLine (cv::Mat& picture,
          const std::string& text,
          const cv::Point& corner,
          int height,
          const cv::Scalar& color,
          bool bold = false);

} // namespace pcl_msf::visualization
