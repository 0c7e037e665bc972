// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/stage_folder.h"

#include <fcntl.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/folders.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
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

enum class Lock { Ours, Held, None };

/** Locks a file. None: it is not there, or this place knows no locks. */
Lock
take (const std::string& file, int flags, int& descriptor)
{
  descriptor = open (file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
  if (descriptor < 0)
    return Lock::None;
  if (flock (descriptor, LOCK_EX | LOCK_NB) == 0)
    return Lock::Ours;
  const bool held = errno == EWOULDBLOCK;
  close (descriptor);
  descriptor = -1;
  return held ? Lock::Held : Lock::None;
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
  int lock = -1;
  if (take (lockOf (stage), 0, lock) != Lock::Ours)
    return;
  std::error_code ignored;
  fs::remove_all (stage, ignored);
  close (lock);
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
  const Lock lock = take (lockOf (path_), O_CREAT, lock_);
  if (lock != Lock::Held && fs::exists (path_))
    return true;
  if (lock_ >= 0)
    close (lock_);
  return false;
}

StageFolder::~StageFolder()
{
  std::error_code ignored;
  fs::remove_all (path_, ignored);
  if (lock_ >= 0)
    close (lock_);
}

} // namespace pcl_msf::tool
