// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "io/base/drawing.h"
#include "io/base/json.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/html_report.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <tuple>
#include <utility>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;

/** What a picture shows, by its name without frames. */
struct PictureKind {
  const char* name;
  const char* caption;
  bool once{false}; ///< one for a window
};

/** Pictures that have captions, in the order in which they are shown; first those of
 * pcl_msf_scene_flow, whose names go on with frames, then those of pcl_msf_render. */
constexpr std::array kKinds{
    PictureKind{"overview", "all on one sheet", true},
    PictureKind{"flow", "optical flow"},
    PictureKind{"segments", "segments"},
    PictureKind{"motions", "motion groups"},
    PictureKind{"weights", "connections"},
    PictureKind{"occlusion", "visibility"},
    PictureKind{"range", "depth"},
    PictureKind{"residual", "residual"},
    PictureKind{"deviation", "standard deviation of the flow"},
    PictureKind{"error", "end-point error"},
    PictureKind{"overlay", "both frames, warped"},
    PictureKind{"convergence", "convergence", true},
};
constexpr std::array kRenders{
    PictureKind{"sheet", "renders"},
    PictureKind{"before", "clouds before"},
    PictureKind{"after", "clouds after warping"},
    PictureKind{"before_tints", "clouds before, in tints"},
    PictureKind{"after_tints", "clouds after warping, in tints"},
    PictureKind{"warped", "the warped reference"},
    PictureKind{"segments", "segments"},
    PictureKind{"motions", "motion groups"},
    PictureKind{"arrows", "displacement"},
    PictureKind{"trajectories", "trajectories"},
    PictureKind{"residual", "brightness residual"},
    PictureKind{"depth_residual", "depth residual"},
    PictureKind{"occlusion", "occlusion"},
};

bool
isKnown (const std::string& name)
{
  return name == "flicker" ||
         std::any_of (kKinds.begin(), kKinds.end(), [&name] (const PictureKind& kind) {
           return name == kind.name;
         });
}

/** Two frames, as names of results have them. */
struct Frames {
  int reference{0};
  int current{-1}; ///< none

  bool
  operator<(const Frames& other) const
  {
    return std::tie (reference, current) < std::tie (other.reference, other.current);
  }
};

/** Names of a folder's pictures and, of those of results, their frames. */
class Pictures {
public:
  explicit Pictures (const fs::path& folder) : folder_ (folder)
  {
    static const std::regex framed ("([a-z_]+?)_([0-9]+)(_([0-9]+))?(_before|_after)?");
    static const std::regex report ("report_([0-9]+)\\.json");
    std::error_code error;
    for (const auto& entry : fs::directory_iterator (folder, error)) {
      const std::string name = entry.path().filename().string();
      const std::string stem = entry.path().stem().string();
      std::smatch parts;
      Frames frames;
      if (std::regex_match (name, parts, report) &&
          parseNumber (parts[1].str(), frames.reference))
        references_.insert (frames.reference);
      if (entry.path().extension() == ".png" &&
          std::regex_match (stem, parts, framed) && isKnown (parts[1].str()) &&
          parseNumber (parts[2].str(), frames.reference)) {
        if (parts[4].matched)
          parseNumber (parts[4].str(), frames.current);
        framed_[parts[1].str() + parts[5].str()][frames] = entry.path().string();
        references_.insert (frames.reference);
      }
    }
    if (references_.empty())
      references_.insert (0);
  }

  const std::set<int>&
  references () const
  {
    return references_;
  }

  /** Those of a kind and a reference, by their frames. */
  std::vector<std::pair<Frames, std::string>>
  of (const std::string& kind, int reference) const
  {
    std::vector<std::pair<Frames, std::string>> found;
    const auto all = framed_.find (kind);
    if (all != framed_.end())
      for (const auto& [frames, path] : all->second)
        if (frames.reference == reference)
          found.emplace_back (frames, path);
    return found;
  }

  /** The one without frames; empty when there is none. */
  std::string
  plain (const std::string& name) const
  {
    const fs::path path = folder_ / (name + ".png");
    return fs::exists (path) ? path.string() : std::string();
  }

private:
  fs::path folder_;
  std::map<std::string, std::map<Frames, std::string>> framed_;
  std::set<int> references_;
};

/** "optical flow, frame 2"; the frame after the reference needs no word. */
std::string
captionOf (const std::string& words, const Frames& frames)
{
  if (frames.current < 0 || frames.current == frames.reference + 1)
    return words;
  return words + ", frame " + std::to_string (frames.current);
}

void
addPictures (const Pictures& pictures, int reference, HtmlEntry& entry)
{
  const auto before = pictures.of ("flicker_before", reference);
  for (const auto& [frames, after] : pictures.of ("flicker_after", reference))
    if (!before.empty()) // the reference of all frames
      entry.comparisons.push_back (
          {{before.front().second, "reference"},
           {after, captionOf ("current frame, carried back", frames)}});
  for (const PictureKind& kind : kKinds) {
    const std::string plain = pictures.plain (kind.name);
    if (kind.once && !plain.empty()) // as version 0.1.0 named it
      entry.pictures.push_back ({plain, kind.caption});
    for (const auto& [frames, path] : pictures.of (kind.name, reference))
      entry.pictures.push_back ({path, captionOf (kind.caption, frames)});
  }
}

/** Pictures that belong to no reference by their names. */
void
addRenders (const Pictures& pictures, HtmlEntry& entry)
{
  const std::string before = pictures.plain ("before_tints");
  const std::string after = pictures.plain ("after_tints");
  if (!before.empty() && !after.empty())
    entry.comparisons.push_back ({{before, "before"}, {after, "after warping"}});
  for (const PictureKind& kind : kRenders)
    if (const std::string path = pictures.plain (kind.name); !path.empty())
      entry.pictures.push_back ({path, kind.caption});
}

/** Numbers worth a table, as far as the report has them: of pcl_msf_scene_flow,
 * pcl_msf_register or pcl_msf_stream. */
std::vector<std::pair<std::string, std::string>>
numbersOf (const Json& report)
{
  constexpr std::pair<const char*, const char*> kShown[] = {
      {"frames", "/frames"},
      {"tracked", "/tracked"},
      {"lost", "/lost"},
      {"dropped", "/dropped"},
      {"frames a second", "/frames_per_second"},
      {"latency, ms", "/latency_ms/median"},
      {"points", "/points"},
      {"width", "/width"},
      {"height", "/height"},
      {"segments", "/segments"},
      {"motion groups", "/bodies"},
      {"joints", "/joints"},
      {"iterations", "/iterations"},
      {"converged", "/converged"},
      {"stop reason", "/stop_reason"},
      {"message", "/message"},
      {"seconds", "/seconds/total"},
      {"cost before", "/cost/initial"},
      {"cost after", "/cost/final"}};
  std::vector<std::pair<std::string, std::string>> numbers;
  for (const auto& [name, place] : kShown) {
    const Json::json_pointer pointer (place);
    const Json value = report.contains (pointer) ? report.at (pointer) : Json();
    std::string text;
    if (value.is_boolean())
      text = value.get<bool>() ? "yes" : "no";
    else if (value.is_number())
      text = shortNumber (value.get<double>());
    else if (value.is_string())
      text = value.get<std::string>();
    if (!text.empty())
      numbers.emplace_back (name, text);
  }
  return numbers;
}

/** Has a tool of this library written it? Other programs write a report.json, too. */
bool
isOwn (const Json& report)
{
  return report.contains ("stop_reason") || // of pcl_msf_stream the others
         (report.contains ("tracked") && report.contains ("lost"));
}

std::vector<std::pair<std::string, std::string>>
readNumbers (const std::string& path)
{
  if (!fs::is_regular_file (path))
    throw IoError (path + ": report: there is none; give a folder of "
                          "pcl_msf_scene_flow");
  std::ifstream stream (path, std::ios::binary);
  if (!stream)
    throw IoError (path + ": report: cannot be opened; check its permissions");
  const Json report = Json::parse (stream, nullptr, false);
  if (!report.is_object())
    throw IoError (path + ": report: it is no JSON object; the file is damaged");
  if (!isOwn (report))
    throw IoError (path + ": report: none of this library; give a folder of "
                          "pcl_msf_scene_flow");
  return numbersOf (report);
}

} // namespace

std::vector<HtmlEntry>
entriesOfFolder (const std::string& folder)
{
  const fs::path base = folder;
  const fs::path absolute = fs::absolute (base / ".").lexically_normal().parent_path();
  const Pictures pictures (base);
  std::vector<HtmlEntry> entries;
  for (const int reference : pictures.references()) {
    HtmlEntry entry;
    entry.name = absolute.filename().string();
    if (pictures.references().size() > 1)
      entry.name += ", reference " + std::to_string (reference);
    const fs::path own = base / ("report_" + std::to_string (reference) + ".json");
    entry.numbers =
        readNumbers (fs::exists (own) ? own.string() : (base / "report.json").string());
    addPictures (pictures, reference, entry);
    if (entries.empty())
      addRenders (pictures, entry);
    entries.push_back (std::move (entry));
  }
  return entries;
}

HtmlEntry
entryOfFolder (const std::string& folder)
{
  return entriesOfFolder (folder).front();
}

std::vector<std::string>
resultFolders (const std::string& folder)
{
  const auto holdsReport = [] (const fs::path& path) {
    return fs::exists (path / "report.json");
  };
  std::vector<std::string> found;
  std::error_code error;
  if (holdsReport (folder))
    found.push_back (folder);
  fs::recursive_directory_iterator entry (folder, error);
  for (; !error && entry != fs::recursive_directory_iterator();
       entry.increment (error)) {
    const bool hidden = entry->path().filename().string().front() == '.';
    if (hidden || entry.depth() >= kDeepest - 1)
      entry.disable_recursion_pending();
    if (!hidden && entry->is_directory (error) && holdsReport (entry->path()))
      found.push_back (entry->path().string());
  }
  std::sort (found.begin(), found.end());
  return found;
}

} // namespace pcl_msf::io
