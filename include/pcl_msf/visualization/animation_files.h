// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_msf::visualization {

/** \brief Joins pictures to an MP4 (H.264, or MPEG-4 where there is no encoder for it)
 * by OpenCV's FFmpeg.
 *
 * The file is written under a temporary name and renamed. Odd sizes lose a row or
 * column. \param path ends in .mp4
 * \param pictures PNG files of one size, in order \param rate pictures per
 * second, > 0 \param cancelled asked before every picture; true gives up \throws
 * IoError for another name, when OpenCV has no encoder, it fails, or it is cancelled */
PCL_MSF_EXPORT void
writeMp4 (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const std::function<bool()>& cancelled = {});

} // namespace pcl_msf::visualization
