// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/output_file.h"

#include <pcl_msf/errors.h>
#include <pcl_msf/io/folders.h>
#include <unistd.h>

#include <atomic>
#include <exception>
#include <filesystem>
#include <fstream>

namespace pcl_msf::io {

namespace {

/** A name of its own for every writer of every process, hidden, beside the target. */
std::string
temporaryName (const std::filesystem::path& path)
{
  static std::atomic<unsigned> counter{0};
  const std::string name = "." + path.filename().string() + "." +
                           std::to_string (getpid()) + "." +
                           std::to_string (counter++) + ".part";
  return (path.parent_path() / name).string();
}

} // namespace

void
makeFolder (const std::string& path)
{
  std::error_code error;
  std::filesystem::create_directories (path, error);
  if (error || !std::filesystem::is_directory (path))
    throw IoError (path + ": the folder cannot be made; choose another");
}

void
writeThenRename (const std::string& path,
                 const std::function<void (const std::string&)>& write)
{
  const std::string temporary = temporaryName (path);
  std::error_code ignored;
  try {
    write (temporary);
    std::filesystem::rename (temporary, path);
  }
  catch (const IoError&) {
    std::filesystem::remove (temporary, ignored);
    throw;
  }
  catch (const std::exception&) {
    std::filesystem::remove (temporary, ignored);
    throw IoError (path + ": cannot be written; check that its folder exists, may be "
                          "written to and has space");
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
