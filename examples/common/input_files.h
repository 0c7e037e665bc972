// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <map>
#include <string>
#include <utility>

namespace pcl_msf::tool {

/** \brief The files that a run reads, known by device and inode: another name, a link
 * or a detour by ".." is the same file. Paths that do not exist are left out. */
class InputFiles {
public:
  /** \brief A file, or a folder with all that is below it; symbolic links are followed.
   * \param except a folder that is not entered unless it is `path` itself */
  void
  add (const std::string& path, const std::string& except = {});

  /** \brief The input that is the same file or folder, as a path; empty when none is.
   */
  std::string
  sameAs (const std::string& path) const;

private:
  using Identity = std::pair<unsigned long long, unsigned long long>;

  static bool
  identify (const std::string& path, Identity& identity);
  void
  walk (const std::string& path, const Identity& except);

  std::map<Identity, std::string> inputs_;
};

/** \brief For a file that is to be written. \param option how it is asked for
 * \throws UsageError naming both when it is one of the inputs */
void
requireNoInput (const std::string& option,
                const std::string& path,
                const InputFiles& inputs);

/** \brief For a folder that is to be written into. \param recording a folder that is
 * read; may be empty \throws UsageError when the output is the recording, or a folder
 * of it that holds images or clouds other than results */
void
requireOutside (const std::string& option,
                const std::string& output,
                const std::string& recording);

} // namespace pcl_msf::tool
