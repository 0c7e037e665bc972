// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief A PNG of the kinds that depth, labels and colour come in, by libpng: 8 or 16
 * bits of grey, 3 x 8 bits of colour. OpenCV's decoder gives the same; this needs none
 * of the libraries of other formats. \param flags as cv::imread's \return BGR; empty
 * for other kinds, for flags that convert, and for damaged files */
cv::Mat
decodePng (const std::vector<unsigned char>& bytes, int flags);

/** \brief The same kinds as a PNG, compressed as cv::imencode does, quickly.
 * \return empty for other kinds */
std::vector<unsigned char>
encodePng (const cv::Mat& image);

} // namespace pcl_msf::io
