// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "merge_shards.h"

#include "common/command_line.h"
#include "common/output_folder.h"
#include "common/output_manifest.h"
#include "window_log.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

struct Part {
  std::string folder;
  WindowLog log;
};

fs::path
placeOfShards (const std::string& output)
{
  return fs::path (output) / "shards";
}

std::vector<Part>
findParts (const std::string& output)
{
  std::vector<Part> parts;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator (placeOfShards (output), error))
    if (fs::exists (entry.path() / WindowLog::kName))
      parts.push_back (
          {entry.path().string(), WindowLog::read (entry.path().string())});
  if (parts.empty())
    throw UsageError ("--merge: " + placeOfShards (output).string() +
                      " holds no shard; run the parts with --shard I/N first");
  for (const Part& part : parts)
    parts.front().log.requireSameRun (part.log, part.folder);
  return parts;
}

/** All windows' records, in their order. \throws UsageError when some are missing */
std::map<int, WindowRecord>
allRecords (const std::vector<Part>& parts)
{
  std::map<int, WindowRecord> records;
  for (const Part& part : parts)
    records.insert (part.log.records().begin(), part.log.records().end());
  const int windows = parts.front().log.windows();
  const int count = parts.front().log.shard().count;
  std::set<int> shards;
  int missing = 0;
  for (int window = 0; window < windows; ++window)
    if (records.count (window) == 0) {
      ++missing;
      shards.insert (window % count + 1);
    }
  std::string names;
  for (const int shard : shards)
    names += (names.empty() ? "" : ", ") + Shard{shard, count}.text();
  if (missing > 0)
    throw UsageError ("--merge: " + std::to_string (missing) + " of " +
                      std::to_string (windows) + " windows are missing; run shard " +
                      names + " again");
  return records;
}

/** The file under a second name, without a copy where the disk can do that. */
void
linkFile (const fs::path& from, const fs::path& to)
{
  std::error_code error;
  fs::create_hard_link (from, to, error);
  if (error)
    fs::copy_file (from, to, fs::copy_options::overwrite_existing);
}

void
removeFolder (const std::string& folder, const char* program)
{
  OutputManifest manifest (folder, program);
  while (!manifest.entries().empty())
    manifest.remove (std::string (manifest.entries().begin()->first));
  manifest.write();
  std::error_code ignored;
  fs::remove (folder, ignored); // fails when somebody else has a file there
}

} // namespace

std::string
folderOfShard (const std::string& output, const Shard& shard)
{
  return (placeOfShards (output) /
          (std::to_string (shard.index) + "_of_" + std::to_string (shard.count)))
      .string();
}

bool
mergeShards (const std::string& output, const char* program)
{
  const std::vector<Part> parts = findParts (output);
  const std::map<int, WindowRecord> records = allRecords (parts);
  OutputFolder merged (output, program);
  const fs::path stage = merged.stage();
  for (const Part& part : parts) {
    const OutputManifest written (part.folder, program);
    for (const auto& file : written.entries())
      if (file.first != WindowLog::kName && file.first != "report.json")
        linkFile (fs::path (part.folder) / file.first, stage / file.first);
  }
  const WindowRecord& last = records.rbegin()->second;
  const std::string report =
      "report_" + std::to_string (last.frames.at (last.reference)) + ".json";
  fs::copy_file (stage / report, stage / "report.json");
  Trajectory trajectory;
  for (const auto& [window, record] : records)
    trajectory.add (record);
  if (trajectory.poses().size() > 2)
    io::writeTrajectory ((stage / "trajectory.txt").string(), trajectory.poses());
  merged.finish();
  for (const Part& part : parts)
    removeFolder (part.folder, program);
  std::error_code ignored;
  fs::remove (placeOfShards (output), ignored);
  return std::all_of (records.begin(), records.end(), [] (const auto& entry) {
    return entry.second.converged;
  });
}

} // namespace pcl_msf::tool
