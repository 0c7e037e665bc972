// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/open_source.h"

#include "common/player/cameras.h"
#include "common/player/grabbed_files.h"
#include "common/player/grabber_source.h"
#include "common/player/recording_source.h"

namespace pcl_msf::tool {

namespace {

std::shared_ptr<const io::RgbdSequence>
openFiles (const PlayerSettings& settings, const OpenRecording& open_recording)
{
  if (settings.grabber == GrabberKind::PcdFiles)
    return openPcdFiles (settings);
  if (settings.grabber == GrabberKind::ImageFiles)
    return openImageFiles (settings);
  auto recording = open_recording (settings.source, settings.reading);
  if (recording->frames() < 2)
    throw UsageError ("'" + settings.source + "': holds one frame; two are needed");
  return recording;
}

} // namespace

std::unique_ptr<FrameSource>
openSource (const PlayerSettings& settings,
            const Warn& warn,
            const OpenRecording& open_recording)
{
  if (!settings.isCamera())
    return std::make_unique<RecordingSource> (
        openFiles (settings, open_recording), settings, warn);
  return std::make_unique<GrabberSource> (
      openCamera (settings), cameraName (settings), settings, warn);
}

} // namespace pcl_msf::tool
