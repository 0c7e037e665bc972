// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/output_folder.h"

#include "common/command_line.h"
#include "common/one_line.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/folders.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <set>
#include <utility>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

std::string
placeOfUnfinished (const std::string& folder)
{
  return (fs::path (folder) / "unfinished").string();
}

/** Names below a folder of all that is no folder, sorted; hidden ones are left out.
 * \param enter which folders to look into, by "name/" */
std::vector<std::string>
filesBelow (const std::string& folder,
            const std::function<bool (const std::string& name)>& enter)
{
  std::vector<std::string> names;
  std::error_code error;
  fs::recursive_directory_iterator entry (folder, error);
  for (; !error && entry != fs::recursive_directory_iterator();
       entry.increment (error)) {
    const std::string name = entry->path().lexically_relative (folder).generic_string();
    const bool hidden = entry->path().filename().string().front() == '.';
    if (fs::is_directory (entry->symlink_status())) {
      if (hidden || !enter (name + "/"))
        entry.disable_recursion_pending();
    }
    else if (!hidden)
      names.push_back (name);
  }
  std::sort (names.begin(), names.end());
  return names;
}

std::vector<std::string>
filesBelow (const std::string& folder)
{
  return filesBelow (folder, [] (const std::string&) { return true; });
}

/** Removes what the tool has written into a folder, and the folder if that was all. */
void
clear (const std::string& folder, const std::string& tool)
{
  OutputManifest manifest (folder, tool);
  while (!manifest.entries().empty())
    manifest.remove (std::string (manifest.entries().begin()->first));
  std::error_code ignored;
  if (fs::is_directory (folder)) {
    manifest.write();
    fs::remove (folder, ignored); // fails unless it is empty
  }
}

} // namespace

OutputFolder::OutputFolder (std::string folder,
                            std::string tool,
                            std::string group,
                            std::string option)
: folder_ (std::move (folder))
, tool_ (std::move (tool))
, group_ (oneLine (std::move (group)))
, option_ (std::move (option))
, stage_ (folder_, tool_)
, manifest_ (folder_, tool_)
{
  keep ([] (const std::string&, const std::string&) { return false; });
}

OutputFolder::~OutputFolder()
{
  try {
    if (!waiting_.empty())
      keepUnfinished();
  }
  catch (const std::exception&) { // the user's files are in the way there, too
    waiting_.clear();
  }
}

void
OutputFolder::keepUnfinished()
{
  OutputFolder unfinished (placeOfUnfinished (folder_), tool_, group_, option_);
  for (const std::string& name : waiting_) {
    const fs::path target = fs::path (unfinished.stage()) / name;
    io::makeFolder (target.parent_path().string());
    fs::rename (fs::path (stage()) / name, target);
  }
  unfinished.finish();
}

void
OutputFolder::keep (const Keep& keep)
{
  earlier_.clear();
  for (const auto& [name, entry] : manifest_.entries())
    if (!keep (name, entry.group))
      earlier_.push_back (name);
}

void
OutputFolder::check (const InputFiles& inputs,
                     const std::function<bool (const std::string& name)>& written) const
{
  for (const std::string& name : earlier_)
    requireNoInput (option_, (fs::path (folder_) / name).string(), inputs);
  for (const std::string& name : filesBelow (folder_, written))
    if (written (name)) {
      requireNoInput (option_, (fs::path (folder_) / name).string(), inputs);
      requireOwn ({name});
    }
}

std::string
OutputFolder::locate (const std::string& name) const
{
  const fs::path staged = fs::path (stage()) / name;
  return (fs::exists (staged) ? staged : fs::path (folder_) / name).string();
}

void
OutputFolder::publish()
{
  waiting_ = filesBelow (stage());
  if (!earlier_.empty())
    return;
  requireOwn (waiting_);
  move (waiting_);
  waiting_.clear();
}

void
OutputFolder::finish()
{
  const std::vector<std::string> names = filesBelow (stage());
  requireOwn (names);
  move (names);
  waiting_.clear();
  const std::set<std::string> written (names.begin(), names.end());
  for (const std::string& name : earlier_)
    if (written.count (name) == 0)
      manifest_.remove (name);
  manifest_.write();
  clear (placeOfUnfinished (folder_), tool_);
}

void
OutputFolder::requireOwn (const std::vector<std::string>& names) const
{
  for (const std::string& name : names) {
    const fs::path path = fs::path (folder_) / name;
    if (fs::exists (fs::symlink_status (path)) && !manifest_.holds (name))
      throw UsageError (option_ + ": " + path.string() + " is in the way: " + tool_ +
                        " has not written it, or it was changed; move it or give "
                        "another folder");
  }
}

void
OutputFolder::move (const std::vector<std::string>& names)
{
  manifest_.add (names, stage(), group_);
  for (const std::string& name : names) {
    const fs::path target = fs::path (folder_) / name;
    io::makeFolder (target.parent_path().string());
    fs::rename (fs::path (stage()) / name, target);
  }
}

} // namespace pcl_msf::tool
