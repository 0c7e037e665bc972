// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <string>

namespace pcl_msf::io {

/** \brief cv::imread whose failures, absurd sizes included, are an IoError.
 * \param flags as cv::imread's \param field what the image is, for the error */
cv::Mat
decodeImage (const std::string& path, int flags, const std::string& field);

} // namespace pcl_msf::io
