// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/figure_parts.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/html_report.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;
constexpr int kMostFrames = 32;
constexpr const char* kFirstFrame = "_0_1";

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

/** A picture as a folder has it for a frame of a window; those that belong to none are
 * the first frame's. Nothing when it is not there. */
std::optional<HtmlPicture>
pictureOf (const fs::path& folder, HtmlPicture picture, int frame)
{
  const std::size_t at = picture.path.find (kFirstFrame);
  if (frame > 1) {
    if (at == std::string::npos)
      return {};
    picture.path.replace (
        at, std::string (kFirstFrame).size(), "_0_" + std::to_string (frame));
    picture.caption += ", frame " + std::to_string (frame);
  }
  picture.path = (folder / picture.path).string();
  if (!fs::exists (picture.path))
    return {};
  return picture;
}

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
  const cv::FileNode converged = report["converged"];
  if (!converged.empty())
    numbers.emplace_back ("converged", converged.real() != 0.0 ? "yes" : "no");
  add ("stop reason", report["stop_reason"]);
  add ("message", report["message"]);
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
  for (int frame = 1; frame <= kMostFrames; ++frame)
    for (const auto& [before, left, after, right] : kComparisons) {
      const auto one = pictureOf (base, {before, left}, frame);
      const auto other = pictureOf (base, {after, right}, frame);
      if (one && other) // the left one is the reference of all frames
        entry.comparisons.push_back ({{one->path, left}, *other});
    }
  for (const HtmlPicture& known : knownPictures())
    for (int frame = 1; frame <= kMostFrames; ++frame)
      if (const auto picture = pictureOf (base, known, frame))
        entry.pictures.push_back (*picture);
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
