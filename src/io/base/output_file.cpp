// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/output_file.h"

#include "io/base/file_lock.h"
#include <fcntl.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/folders.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestExtension = 8;
constexpr int kMostLinks = 40; // as Linux has it

[[noreturn]] void
failToWrite (const fs::path& path)
{
  throw IoError (path.string() + ": cannot be written; check that its folder exists, "
                                 "may be written to and has space");
}

/** The file that links lead to, so that they stay; it need not be there. */
fs::path
placeOf (const fs::path& path)
{
  fs::path place = path;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink (place, error); ++i)
    place = place.parent_path() / fs::read_symlink (place, error);
  const fs::file_status there = fs::status (place, error);
  if (fs::exists (there) && !fs::is_regular_file (there))
    throw IoError (path.string() + ": cannot be written: what is there is no regular "
                                   "file; give another name");
  return place;
}

/** A file of its own for every writer of every process, hidden, locked while it is
 * written; gone in the end, unless it was renamed. */
class TemporaryFile {
public:
  explicit TemporaryFile (const fs::path& target)
  {
    const std::string extension = target.extension().string();
    while (!make (target.parent_path() /
                  (".pcl_msf." + std::to_string (getpid()) + "." +
                   std::to_string (next()) + ".part" +
                   (extension.size() > kLongestExtension ? "" : extension))))
      ;
    if (!lock_->isOpen())
      failToWrite (target);
  }
  ~TemporaryFile()
  {
    std::error_code ignored;
    if (!path_.empty())
      fs::remove (path_, ignored);
  }
  TemporaryFile (const TemporaryFile&) = delete;
  TemporaryFile&
  operator= (const TemporaryFile&) = delete;

  std::string
  path () const
  {
    return path_.string();
  }
  void
  rename (const fs::path& target)
  {
    fs::rename (path_, target);
    path_.clear();
  }

  /** Those of writers that are no more, in a folder. */
  static void
  removeDead (const fs::path& folder)
  {
    static const std::regex name (R"(\.pcl_msf\.[0-9]+\.[0-9]+\.part(\..*)?)");
    std::error_code error;
    fs::directory_iterator entry (folder.empty() ? "." : folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment (error)) {
      const std::string file = entry->path().filename().string();
      if (file.front() != '.' || !std::regex_match (file, name) ||
          !fs::is_regular_file (entry->symlink_status()))
        continue;
      std::error_code ignored;
      if (FileLock (entry->path().string()).isOurs())
        fs::remove (entry->path(), ignored);
    }
  }

private:
  static unsigned
  next ()
  {
    static std::atomic<unsigned> counter{0};
    return counter++;
  }
  /** False when the name is taken, or another writer took the file for dead before it
   * was locked. */
  bool
  make (const fs::path& path)
  {
    lock_ = std::make_unique<FileLock> (path.string(), O_CREAT | O_EXCL);
    if (!lock_->isOpen())
      return errno != EEXIST;
    if (lock_->isHeld() || !fs::exists (path))
      return false;
    path_ = path;
    return true;
  }

  fs::path path_;
  std::unique_ptr<FileLock> lock_;
};

/** What is there in place of a folder or of one above it; empty when nothing is. */
std::string
fileOnTheWay (const fs::path& folder)
{
  std::error_code error;
  fs::path part = folder;
  while (part.has_relative_path() && !fs::exists (part, error))
    part = part.parent_path();
  const bool found = fs::exists (part, error) && !fs::is_directory (part, error);
  return found ? part.string() : std::string();
}

} // namespace

void
makeFolder (const std::string& path)
{
  std::error_code error;
  fs::create_directories (path, error);
  if (!error && fs::is_directory (path))
    return;
  const std::string file = fileOnTheWay (path);
  if (!file.empty())
    throw IoError (path + ": the folder cannot be made, for '" + file +
                   "' is a file; move that or choose another folder");
  throw IoError (path + ": the folder cannot be made; choose another");
}

void
writeThenRename (const std::string& path,
                 const std::function<void (const std::string&)>& write)
{
  const fs::path place = placeOf (path);
  TemporaryFile::removeDead (place.parent_path());
  TemporaryFile temporary (place);
  try {
    write (temporary.path());
    temporary.rename (place);
  }
  catch (const IoError&) {
    throw;
  }
  catch (const std::exception&) {
    failToWrite (path);
  }
}

void
writeBytes (const std::string& path, const void* bytes, std::size_t size)
{
  writeThenRename (path, [bytes, size] (const std::string& temporary) {
    std::ofstream stream;
    stream.exceptions (std::ios::failbit | std::ios::badbit);
    stream.open (temporary, std::ios::binary | std::ios::trunc);
    stream.write (static_cast<const char*> (bytes),
                  static_cast<std::streamsize> (size));
    stream.close();
  });
}

} // namespace pcl_msf::io
