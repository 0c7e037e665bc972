// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/figure_parts.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/html_report.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;

/** Pictures that have captions, in the order in which they are shown. */
const std::vector<HtmlPicture>&
knownPictures ()
{
  static const std::vector<HtmlPicture> kKnown{
      {"overview.png", "all on one sheet"},
      {"flow_0_1.png", "optical flow"},
      {"segments_0.png", "segments"},
      {"motions_0.png", "motion groups"},
      {"weights_0.png", "connections"},
      {"occlusion_0_1.png", "visibility"},
      {"depth_0.png", "depth"},
      {"residual_0_1.png", "residual"},
      {"error_0_1.png", "end-point error"},
      {"overlay_0_1.png", "both frames, warped"},
      {"convergence.png", "convergence"},
      {"sheet.png", "renders"},
      {"before.png", "clouds before"},
      {"after.png", "clouds after warping"},
      {"before_tints.png", "clouds before, in tints"},
      {"after_tints.png", "clouds after warping, in tints"},
      {"warped.png", "the warped reference"},
      {"segments.png", "segments"},
      {"motions.png", "motion groups"},
      {"arrows.png", "displacement"},
      {"trajectories.png", "trajectories"},
      {"residual.png", "brightness residual"},
      {"depth_residual.png", "depth residual"},
      {"occlusion.png", "occlusion"}};
  return kKnown;
}

const std::array<std::array<const char*, 4>, 2> kComparisons{
    {{"flicker_0_1_before.png",
      "reference",
      "flicker_0_1_after.png",
      "current frame, carried back"},
     {"before_tints.png", "before", "after_tints.png", "after warping"}}};

std::string
textOf (const cv::FileNode& node)
{
  if (node.isString())
    return node.string();
  return node.isInt() || node.isReal() ? shortNumber (node.real()) : std::string();
}

/** Numbers worth a table, as far as the report has them. */
std::vector<std::pair<std::string, std::string>>
numbersOf (const cv::FileStorage& report)
{
  std::vector<std::pair<std::string, std::string>> numbers;
  const auto add = [&numbers] (const char* name, const cv::FileNode& node) {
    const std::string text = textOf (node);
    if (!text.empty())
      numbers.emplace_back (name, text);
  };
  add ("frames", report["frames"]);
  add ("width", report["width"]);
  add ("height", report["height"]);
  add ("segments", report["segments"]);
  add ("motion groups", report["bodies"]);
  add ("iterations", report["iterations"]);
  add ("stop reason", report["stop_reason"]);
  add ("seconds", report["seconds"]["total"]);
  add ("cost before", report["cost"]["initial"]);
  add ("cost after", report["cost"]["final"]);
  return numbers;
}

std::vector<std::pair<std::string, std::string>>
readNumbers (const std::string& path)
{
  if (!fs::is_regular_file (path))
    throw IoError (path + ": report: there is none; give a folder of "
                          "pcl_msf_scene_flow");
  try {
    const cv::FileStorage report (path,
                                  cv::FileStorage::READ | cv::FileStorage::FORMAT_JSON);
    if (report.isOpened())
      return numbersOf (report);
  }
  catch (const cv::Exception&) {
    throw IoError (path + ": report: it is no JSON; the file is damaged");
  }
  throw IoError (path + ": report: cannot be read");
}

} // namespace

HtmlEntry
entryOfFolder (const std::string& folder)
{
  const fs::path base = folder;
  HtmlEntry entry;
  entry.name = fs::absolute (base).lexically_normal().filename().string();
  if (entry.name.empty())
    entry.name =
        fs::absolute (base).lexically_normal().parent_path().filename().string();
  entry.numbers = readNumbers ((base / "report.json").string());
  for (const auto& [before, left, after, right] : kComparisons)
    if (fs::exists (base / before) && fs::exists (base / after))
      entry.comparisons.push_back (
          {{(base / before).string(), left}, {(base / after).string(), right}});
  for (const HtmlPicture& picture : knownPictures())
    if (fs::exists (base / picture.path))
      entry.pictures.push_back ({(base / picture.path).string(), picture.caption});
  return entry;
}

std::vector<std::string>
resultFolders (const std::string& folder)
{
  std::vector<std::string> found;
  std::error_code error;
  if (fs::exists (fs::path (folder) / "report.json"))
    found.push_back (folder);
  fs::recursive_directory_iterator entry (folder, error);
  for (; !error && entry != fs::recursive_directory_iterator();
       entry.increment (error)) {
    if (entry.depth() >= kDeepest - 1)
      entry.disable_recursion_pending();
    if (entry->is_directory (error) && fs::exists (entry->path() / "report.json"))
      found.push_back (entry->path().string());
  }
  std::sort (found.begin(), found.end());
  return found;
}

} // namespace pcl_msf::io
