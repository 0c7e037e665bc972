// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief cv::imdecode and cv::imencode, whose library is loaded here where it can be.
 * PNG images of the usual kinds need no such library.
 * \throws cv::Exception as these; InvalidInput when the library cannot be loaded */
cv::Mat
decodeBytes (const std::vector<unsigned char>& bytes, int flags);

/** \param extension with its dot, as ".png" \return empty: cannot be encoded so */
std::vector<unsigned char>
encodeBytes (const std::string& extension, const cv::Mat& image);

} // namespace pcl_msf::io
