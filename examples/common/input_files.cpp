// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/input_files.h"

#include "common/command_line.h"
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <system_error>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

/** An image, depth or cloud file, by its name. */
bool
isFrameFile (const fs::path& path)
{
  static const std::set<std::string> types{".png",
                                           ".jpg",
                                           ".jpeg",
                                           ".ppm",
                                           ".pgm",
                                           ".webp",
                                           ".tif",
                                           ".tiff",
                                           ".exr",
                                           ".dpt",
                                           ".pfm",
                                           ".pcd"};
  std::string type = path.extension().string();
  std::transform (type.begin(), type.end(), type.begin(), [] (unsigned char c) {
    return static_cast<char> (std::tolower (c));
  });
  return types.count (type) > 0;
}

/** Results are there already, or nothing that a recording is made of. */
bool
isFreeForResults (const std::string& folder)
{
  if (fs::exists (fs::path (folder) / ".pcl_msf_scene_flow"))
    return true;
  std::error_code error;
  for (fs::directory_iterator entry (folder, error);
       !error && entry != fs::directory_iterator();
       entry.increment (error))
    if (isFrameFile (entry->path()))
      return false;
  return true;
}

} // namespace

void
InputFiles::add (const std::string& path, const std::string& except)
{
  Identity skipped{}, own{};
  if (!identify (path, own))
    return;
  if (!identify (except, skipped) || skipped == own)
    skipped = {};
  walk (path, skipped);
}

std::string
InputFiles::sameAs (const std::string& path) const
{
  Identity identity;
  const auto found =
      identify (path, identity) ? inputs_.find (identity) : inputs_.end();
  return found == inputs_.end() ? std::string() : found->second;
}

bool
InputFiles::identify (const std::string& path, Identity& identity)
{
  struct stat status {};
  if (path.empty() || stat (path.c_str(), &status) != 0)
    return false;
  identity = {status.st_dev, status.st_ino};
  return true;
}

void
InputFiles::walk (const std::string& path, const Identity& except)
{
  Identity identity;
  // Each once: a link to a folder above leads nowhere new.
  if (!identify (path, identity) || identity == except ||
      !inputs_.emplace (identity, path).second)
    return;
  std::error_code error;
  fs::directory_iterator entry (path, error); // a file has no entries
  for (; !error && entry != fs::directory_iterator(); entry.increment (error))
    walk (entry->path().string(), except);
}

void
requireNoInput (const std::string& option,
                const std::string& path,
                const InputFiles& inputs)
{
  const std::string input = inputs.sameAs (path);
  if (!input.empty())
    throw UsageError (option + ": '" + path + "' is the input '" + input +
                      "', which would be lost; give another name");
}

void
requireOutside (const std::string& option,
                const std::string& output,
                const std::string& recording)
{
  InputFiles files;
  files.add (recording);
  const std::string part = files.sameAs (output);
  if (part.empty() || (part != recording && isFreeForResults (output)))
    return;
  throw UsageError (option + ": '" + output + "' is " +
                    (part == recording ? "" : "a part of ") + "the recording '" +
                    recording + "', which is read; give another folder");
}

} // namespace pcl_msf::tool
