// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace pcl_msf::io {

FileLock::FileLock (const std::string& path, int flags)
: descriptor_ (open (path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0666))
{
  if (descriptor_ < 0)
    return;
  ours_ = flock (descriptor_, LOCK_EX | LOCK_NB) == 0;
  held_ = !ours_ && errno == EWOULDBLOCK;
}

FileLock::~FileLock()
{
  if (descriptor_ >= 0)
    close (descriptor_);
}

} // namespace pcl_msf::io
