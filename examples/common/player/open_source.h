// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/frame_maker.h"
#include "common/player/frame_source.h"
#include "common/recordings.h"

#include <functional>
#include <memory>

namespace pcl_msf::tool {

/** \brief Opens a recording, as openFrames does. */
using OpenRecording = std::function<std::shared_ptr<const io::RgbdSequence> (
    const std::string&, const io::DatasetOptions&)>;

/** \brief The frames that the settings name: a recording's, of one of PCL's grabbers of
 * files, or a live camera's. The settings must outlive the source.
 * \throws UsageError, IoError naming the source and the remedy */
std::unique_ptr<FrameSource>
openSource (const PlayerSettings& settings,
            const Warn& warn,
            const OpenRecording& open_recording = openFrames);

} // namespace pcl_msf::tool
