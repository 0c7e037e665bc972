// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <string>

namespace pcl_msf::io {

/** \brief The first four bytes of .flo, .dpt and .cam. */
constexpr float kFloatTag = 202021.25F;

/** \brief The layout that .flo and .dpt share: float 202021.25, int32 width, int32
 * height, rows of `channels` float32. \throws IoError */
cv::Mat
readTaggedFloats (const std::string& path, int channels);

/** \brief Throws what readTaggedFloats would, without reading the pixels. */
void
checkTaggedFloats (const std::string& path, int channels);

/** \brief Writes that layout. \throws IoError */
void
writeTaggedFloats (const std::string& path, const cv::Mat& image);

} // namespace pcl_msf::io
