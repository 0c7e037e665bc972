// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pcl_msf::visualization {

/** \brief Joins pictures to an animated GIF by the ffmpeg or ImageMagick that is found
 * on PATH.
 *
 * The file is written under a temporary name and renamed.
 * \param pictures PNG files of one size, in order \param rate pictures per second, > 0
 * \param cancelled asked now and then; true gives up
 * \throws IoError when there is no encoder (says what to install), it fails, or it is
 * cancelled */
void
writeGif (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const std::function<bool()>& cancelled = {});

/** \brief Joins pictures to an MP4 (H.264) by the ffmpeg on PATH, or by OpenCV when its
 * build can. Odd sizes lose a row or column. Otherwise as writeGif. */
void
writeMp4 (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const std::function<bool()>& cancelled = {});

} // namespace pcl_msf::visualization
