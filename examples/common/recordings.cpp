// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/recordings.h"

#include <algorithm>
#include <exception>
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

CLI::Option*
addCamera (CLI::App& app, const std::string& help, std::optional<PinholeCamera>& value)
{
  return addOption (
      app, "--camera", "FX,FY,CX,CY", help, [&value] (const std::string& text) {
        return parseCamera (text, value.emplace());
      });
}

CLI::Option*
addDistortion (CLI::App& app,
               const std::string& name,
               const std::string& help,
               const std::function<void (const LensDistortion&)>& take)
{
  return addOption (
      app, name, "K1,K2,P1,P2[,K3]", help, [take] (const std::string& text) {
        LensDistortion lens;
        const bool read = parseDistortion (text, lens);
        if (read)
          take (lens);
        return read;
      });
}

CLI::Option*
addDistortion (CLI::App& app,
               const std::string& help,
               std::optional<LensDistortion>& value)
{
  return addDistortion (app,
                        "--distortion",
                        help,
                        [&value] (const LensDistortion& lens) { value = lens; });
}

CLI::Option*
addDepthScale (CLI::App& app, const std::string& help, std::optional<double>& value)
{
  return addOption (
      app, "--depth-scale", "S", help, [&value] (const std::string& text) {
        return parse (text, value.emplace()) && *value > 0.0;
      });
}

CLI::Option*
addMaxTimeDifference (CLI::App& app, const std::string& help, double& value)
{
  const auto take = [&value] (const std::string& text) {
    return parse (text, value) && value > 0.0;
  };
  return addOption (
      app, "--max-time-difference", "SECONDS", help, take, presetText (value));
}

void
addReadingOptions (CLI::App& app, io::DatasetOptions& options)
{
  addCamera (app, "pinhole camera of the frames, pixels [their own]", options.camera);
  addDistortion (app,
                 "of the frames' images, taken out; OpenCV's order [their own]",
                 options.distortion);
  addDepthScale (app,
                 "units per metre of the frames' 16-bit depth [their own]",
                 options.depth_scale);
}

std::shared_ptr<const io::RgbdSequence>
openFrames (const std::string& path, const io::DatasetOptions& options)
{
  const auto sequences = io::openDataset (io::DatasetKind::Automatic, path, options);
  if (sequences.size() != 1)
    throw UsageError ("'" + path + "': holds " + std::to_string (sequences.size()) +
                      " sequences; give one of their folders");
  return sequences.front();
}

std::shared_ptr<const io::RgbdSequence>
openFramesNotResults (const std::string& path, const io::DatasetOptions& options)
{
  const bool results = fs::exists (fs::path (path) / "report.json");
  try {
    auto frames = openFrames (path, options);
    if (!results || frames->frames() > 1)
      return frames;
  }
  catch (const std::exception&) {
    if (!results)
      throw;
  }
  throw UsageError ("'" + path +
                    "': holds results without scene_flow_R_K.pcd, which is shown; "
                    "pcl_msf_scene_flow writes it, with 'cloud' among its --outputs");
}

void
requireFrame (const io::RgbdSequence& frames, int frame)
{
  if (frame >= frames.frames())
    throw UsageError (frames.name() + " has " + std::to_string (frames.frames()) +
                      " frames, there is no frame " + std::to_string (frame) +
                      "; choose another by --frame, --reference or --window");
}

} // namespace pcl_msf::tool
