// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/stage_folder.h"

#include <fcntl.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/folders.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

constexpr const char* kLock = ".lock"; // no result is hidden
constexpr const char* kAnyName = "XXXXXX";

/** What mkdtemp takes, and makes names of. */
std::string
pattern (const std::string& tool)
{
  return "." + tool + "." + kAnyName;
}

std::string
lockOf (const std::string& stage)
{
  return (fs::path (stage) / kLock).string();
}

/** Stages of the tool's runs, dead or alive. */
std::vector<std::string>
stagesIn (const std::string& folder, const std::string& tool)
{
  const std::string name = pattern (tool);
  const std::size_t known = name.size() - std::string (kAnyName).size();
  std::vector<std::string> stages;
  std::error_code error;
  for (fs::directory_iterator entry (folder, error);
       !error && entry != fs::directory_iterator();
       entry.increment (error)) {
    const std::string file = entry->path().filename().string();
    if (file.size() == name.size() && file.compare (0, known, name, 0, known) == 0 &&
        fs::is_directory (entry->symlink_status()))
      stages.push_back (entry->path().string());
  }
  return stages;
}

/** A stage without a lock may be a run's that has just begun, or not ours: it stays. */
void
removeDead (const std::string& stage)
{
  std::error_code ignored;
  if (io::FileLock (lockOf (stage)).isOurs())
    fs::remove_all (stage, ignored);
}

} // namespace

StageFolder::StageFolder (const std::string& folder, const std::string& tool)
{
  io::makeFolder (folder);
  for (const std::string& stage : stagesIn (folder, tool))
    removeDead (stage);
  while (!make ((fs::path (folder) / pattern (tool)).string()))
    ;
}

/** False when another run took it for dead, before it was locked. */
bool
StageFolder::make (const std::string& pattern)
{
  path_ = pattern;
  if (mkdtemp (path_.data()) == nullptr)
    throw IoError (fs::path (pattern).parent_path().string() +
                   ": the folder may not be written to; choose another");
  lock_ = std::make_unique<io::FileLock> (lockOf (path_), O_CREAT);
  return !lock_->isHeld() && fs::exists (path_);
}

StageFolder::~StageFolder()
{
  std::error_code ignored;
  fs::remove_all (path_, ignored);
}

} // namespace pcl_msf::tool
