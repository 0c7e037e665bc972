// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/recordings.h"

#include "common/option_values.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <tuple>

namespace pcl_msf::tool {

namespace fs = std::filesystem;

std::vector<ResultPair>
resultPairs (const std::string& folder)
{
  static const std::regex name ("scene_flow_([0-9]{1,9})_([0-9]{1,9})\\.pcd");
  std::vector<ResultPair> pairs;
  std::error_code error;
  std::smatch parts;
  for (const auto& entry : fs::directory_iterator (folder, error)) {
    const std::string file = entry.path().filename().string();
    if (std::regex_match (file, parts, name))
      pairs.push_back ({std::stoi (parts[1]), std::stoi (parts[2])});
  }
  // By reference, those after it first.
  std::sort (pairs.begin(), pairs.end(), [] (const ResultPair& a, const ResultPair& b) {
    const bool a_before = a.current < a.reference, b_before = b.current < b.reference;
    return std::tie (a.reference, a_before, a.current) <
           std::tie (b.reference, b_before, b.current);
  });
  return pairs;
}

std::vector<Option>
readingOptions (io::DatasetOptions& options)
{
  return {{"--camera",
           "FX,FY,CX,CY",
           "pinhole camera of the frames, pixels [their own]",
           camera (options.camera)},
          {"--depth-scale",
           "S",
           "units per metre of the frames' 16-bit depth [their own]",
           positive (options.depth_scale)}};
}

std::shared_ptr<const io::RgbdSequence>
openFrames (const std::string& path, const io::DatasetOptions& options)
{
  const auto sequences = io::openDataset ("auto", path, options);
  if (sequences.size() != 1)
    throw UsageError ("'" + path + "': holds " + std::to_string (sequences.size()) +
                      " sequences; give one of their folders");
  return sequences.front();
}

} // namespace pcl_msf::tool
