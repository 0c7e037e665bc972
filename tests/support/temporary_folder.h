// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace pcl_msf::testing {

/** \brief A folder of its own for one test, removed at its end. */
class TemporaryFolder {
public:
  TemporaryFolder()
  {
    std::string name =
        (std::filesystem::temp_directory_path() / "pcl_msf_test_XXXXXX").string();
    if (!mkdtemp (name.data()))
      throw std::runtime_error ("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all (path_, ignored);
  }
  TemporaryFolder (const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator= (const TemporaryFolder&) = delete;

  std::string
  operator() (const std::string& name) const
  {
    return (path_ / name).string();
  }

private:
  std::filesystem::path path_;
};

inline void
writeFile (const std::string& path, const std::string& bytes)
{
  std::ofstream (path, std::ios::binary) << bytes;
}

inline std::string
readFile (const std::string& path)
{
  std::ifstream stream (path, std::ios::binary);
  return {std::istreambuf_iterator<char> (stream), {}};
}

inline std::size_t
filesIn (const std::string& folder)
{
  const std::filesystem::directory_iterator begin (folder), end;
  return static_cast<std::size_t> (std::distance (begin, end));
}

} // namespace pcl_msf::testing
