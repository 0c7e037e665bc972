// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/output_manifest.h"

#include <pcl_msf/errors.h>
#include <pcl_msf/io/text_files.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <utility>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

/** FNV-1a over a file's bytes, eight at a time; false when they cannot be read. It
 * tells changes, not attacks. */
bool
hashOf (const fs::path& path, std::uint64_t& hash)
{
  std::ifstream stream (path, std::ios::binary);
  hash = 14695981039346656037ULL;
  std::array<std::uint64_t, 1 << 13> words{};
  while (stream) {
    words.fill (0);
    stream.read (reinterpret_cast<char*> (words.data()), sizeof words);
    for (const std::uint64_t word : words) {
      hash = (hash ^ word) * 1099511628211ULL;
      hash ^= hash >> 32U;
    }
  }
  return stream.eof();
}

/** A name that stays inside the folder, and in its line. */
bool
isSafe (const fs::path& name)
{
  if (name.empty() || name.is_absolute() ||
      name.string().find ('\n') != std::string::npos)
    return false;
  for (const fs::path& part : name)
    if (part == "..")
      return false;
  return true;
}

std::string
lineOf (const std::string& name, const OutputManifest::Entry& entry)
{
  return std::to_string (entry.size) + '\t' + std::to_string (entry.hash) + '\t' +
         entry.group + '\t' + name + '\n';
}

template <typename Number>
bool
take (std::string& line, Number& value)
{
  const std::size_t tab = line.find ('\t');
  const char* end = line.data() + std::min (tab, line.size());
  const auto result = std::from_chars (line.data(), end, value);
  if (tab == std::string::npos || result.ec != std::errc() || result.ptr != end)
    return false;
  line.erase (0, tab + 1);
  return true;
}

bool
parse (std::string line, std::string& name, OutputManifest::Entry& entry)
{
  if (!take (line, entry.size) || !take (line, entry.hash))
    return false;
  const std::size_t tab = line.find ('\t');
  if (tab == std::string::npos)
    return false;
  entry.group = line.substr (0, tab);
  name = line.substr (tab + 1);
  return isSafe (name);
}

} // namespace

OutputManifest::OutputManifest (std::string folder, const std::string& tool)
: folder_ (std::move (folder))
, path_ ((fs::path (folder_) / ("." + tool)).string())
, head_ ("# Files of " + tool + " in this folder: size, hash, group, name.\n")
{
  std::ifstream stream (path_, std::ios::binary);
  if (!stream)
    return;
  std::string line, name;
  std::getline (stream, line);
  cut_ = stream.eof() && head_.compare (0, line.size(), line) == 0;
  if (cut_)
    return;
  if (line + '\n' != head_)
    throw IoError (path_ + ": head: not a list of files of " + tool +
                   "; remove it or give another folder");
  while (std::getline (stream, line)) {
    cut_ = stream.eof();
    if (cut_)
      return;
    Entry entry;
    if (!parse (line, name, entry))
      throw IoError (path_ + ": entry: '" + line +
                     "' is damaged; remove the file or give another folder");
    entries_[name] = entry;
  }
}

bool
OutputManifest::holds (const std::string& name) const
{
  const auto entry = entries_.find (name);
  const fs::path path = fs::path (folder_) / name;
  std::error_code error;
  std::uint64_t hash = 0;
  return entry != entries_.end() && fs::is_regular_file (fs::symlink_status (path)) &&
         fs::file_size (path, error) == entry->second.size && !error &&
         hashOf (path, hash) && hash == entry->second.hash;
}

void
OutputManifest::add (const std::vector<std::string>& names,
                     const std::string& source,
                     const std::string& group)
{
  if (cut_)
    write();
  cut_ = false;
  std::string text = fs::exists (path_) ? std::string() : head_;
  for (const std::string& name : names) {
    const fs::path path = fs::path (source) / name;
    std::error_code error;
    Entry entry{fs::file_size (path, error), 0, group};
    if (error || !hashOf (path, entry.hash))
      throw IoError (path.string() + ": cannot be read back; check the disk");
    text += lineOf (name, entry);
    entries_[name] = entry;
  }
  std::ofstream stream (path_, std::ios::binary | std::ios::app);
  if (!(stream << text << std::flush))
    throw IoError (path_ + ": cannot be written; check that its folder may be written "
                           "to and has space");
}

void
OutputManifest::remove (const std::string& name)
{
  std::error_code ignored;
  const fs::path path = fs::path (folder_) / name;
  if (holds (name))
    fs::remove (path, ignored);
  if (path.parent_path() != fs::path (folder_))
    fs::remove (path.parent_path(), ignored); // fails unless it is empty
  entries_.erase (name);
}

void
OutputManifest::write() const
{
  if (entries_.empty()) {
    std::error_code ignored;
    fs::remove (path_, ignored);
    return;
  }
  std::string text = head_;
  for (const auto& [name, entry] : entries_)
    text += lineOf (name, entry);
  io::writeText (path_, text);
}

} // namespace pcl_msf::tool
