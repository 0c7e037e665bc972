// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/grabbed_files.h"

#include <filesystem>

namespace pcl_msf::tool {

std::optional<io::CameraFile>
cameraBeside (const PlayerSettings& settings)
{
  const std::filesystem::path source = settings.source;
  const auto folder =
      std::filesystem::is_directory (source) ? source : source.parent_path();
  const auto file = folder / "camera.txt";
  if (!std::filesystem::exists (file))
    return std::nullopt;
  return io::readCamera (file.string());
}

} // namespace pcl_msf::tool
