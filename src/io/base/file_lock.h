// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <string>

namespace pcl_msf::io {

/** \brief A lock on a file, which the system opens when the process ends, however it
 * ends: it tells what a run that was killed has left from what a living one works on.
 * Two locks on one file exclude each other within a process, too. */
class PCL_MSF_EXPORT FileLock {
public:
  /** \brief Takes the lock, if it is free; never waits. \param flags more flags of
   * open(), for example O_CREAT. A symbolic link is not followed. */
  explicit FileLock (const std::string& path, int flags = 0);

  /** \brief Lets the lock go; the file stays. */
  ~FileLock();
  FileLock (const FileLock&) = delete;
  FileLock&
  operator= (const FileLock&) = delete;

  /** \brief Could the file be opened? */
  bool
  isOpen () const
  {
    return descriptor_ >= 0;
  }

  /** \brief Is the lock ours? Never where the file system has no locks. */
  bool
  isOurs () const
  {
    return ours_;
  }

  /** \brief Does somebody else hold it? */
  bool
  isHeld () const
  {
    return held_;
  }

private:
  int descriptor_;
  bool ours_{false};
  bool held_{false};
};

} // namespace pcl_msf::io
