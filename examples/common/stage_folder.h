// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "io/base/file_lock.h"

#include <memory>
#include <string>

namespace pcl_msf::tool {

/** \brief A hidden folder of one run inside a folder of results, with a lock in it that
 * the system opens when the run ends, however it ends. So a later run can tell the
 * stage of a run that was killed from that of one that goes on. */
class StageFolder {
public:
  /** \brief Makes one, and removes those of the tool's runs that are no more.
   * \throws IoError */
  StageFolder (const std::string& folder, const std::string& tool);

  /** \brief Removes it. */
  ~StageFolder();
  StageFolder (const StageFolder&) = delete;
  StageFolder&
  operator= (const StageFolder&) = delete;

  const std::string&
  path () const
  {
    return path_;
  }

private:
  bool
  make (const std::string& pattern);

  std::string path_;
  std::unique_ptr<io::FileLock> lock_;
};

} // namespace pcl_msf::tool
