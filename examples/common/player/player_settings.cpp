// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/player_settings.h"

#include <CLI/App.hpp>

namespace pcl_msf::tool {

CLI::Option*
addRateOption (CLI::App& app, PlayerSettings& settings)
{
  return addOption (app,
                    "--rate",
                    "HZ",
                    "frames a second, above 0 [by the recording's times, else 30]",
                    [&settings] (const std::string& text) {
                      return parse (text, settings.rate.emplace()) &&
                             *settings.rate > 0.0;
                    });
}

CLI::Option*
addGrabberOption (CLI::App& app, PlayerSettings& settings)
{
  const Words<GrabberKind> words{{"pcd", GrabberKind::PcdFiles},
                                 {"image", GrabberKind::ImageFiles},
                                 {"openni2", GrabberKind::OpenNI2},
                                 {"realsense2", GrabberKind::RealSense2}};
  return addWord (app,
                  "--grabber",
                  "read by one of PCL's grabbers: files, or a live camera",
                  settings.grabber,
                  words);
}

void
checkSource (const PlayerSettings& settings, const std::string& name)
{
  const bool camera = settings.isCamera();
  if (settings.source.empty() && !camera)
    throw UsageError (name + ": missing; only a camera (--grabber) needs none");
  if (settings.grabber != GrabberKind::None && settings.reading.distortion)
    throw UsageError ("--distortion: clouds of a --grabber have none");
  if (camera && settings.rate)
    throw UsageError ("--rate: a camera has its own");
  if (camera && settings.every_frame)
    throw UsageError ("--as-fast-as-possible: a camera does not wait");
}

} // namespace pcl_msf::tool
