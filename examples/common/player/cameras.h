// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/io/grabber.h>

#include "common/player/player_settings.h"

#include <memory>
#include <string>

namespace pcl_msf::tool {

/** \brief What to call the camera in messages. */
std::string
cameraName (const PlayerSettings& settings);

/** \brief Opens a live camera by the grabber that PCL has for it. `settings.source` is
 * what that takes: "#1" for the first one, a serial number, a file of its recorder;
 * empty for any camera.
 * \throws UsageError when there is no such camera, or PCL was built without it */
std::unique_ptr<pcl::Grabber>
openCamera (const PlayerSettings& settings);

} // namespace pcl_msf::tool
