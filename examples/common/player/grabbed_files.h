// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/player_settings.h"
#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/io/text_files.h>

#include <memory>
#include <optional>

namespace pcl_msf::tool {

/* Recordings that PCL's grabbers of files read, by `pcl::FileGrabber`, the interface by
 * which they give any cloud of their list. Files that PCL would crash on, or misread,
 * are refused before. */

/** \brief What the camera.txt in the source's folder says; none without one. \throws
 * IoError for a damaged one */
std::optional<io::CameraFile>
cameraBeside (const PlayerSettings& settings);

/** \brief Organized clouds, by `pcl::PCDGrabber`. `settings.source` is a folder of .pcd
 * files or a text file that lists them, one per line, from its own folder; the camera
 * is that of the settings, of camera.txt, or of the first cloud.
 * \throws IoError, UsageError unless there are two or more */
std::shared_ptr<const io::RgbdSequence>
openPcdFiles (const PlayerSettings& settings);

/** \brief Images, by `pcl::ImageGrabber`. `settings.source` is a folder with "depth"
 * and, if there is colour, "rgb" in the names of its images, paired by their order; or
 * of .pclzf files, which have their cameras beside them.
 * \throws IoError, UsageError unless there are two or more */
std::shared_ptr<const io::RgbdSequence>
openImageFiles (const PlayerSettings& settings);

} // namespace pcl_msf::tool
