// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/shard.h"
#include "trajectory.h"

#include <map>
#include <string>

namespace pcl_msf::tool {

/** \brief Which windows of a recording a shard has finished: the file windows.json in
 * its folder, by which it goes on where it was and the shards are merged. */
class WindowLog {
public:
  static constexpr const char* kName = "windows.json";

  /** \param settings what results depend on, as one line \param windows of the whole
   * recording */
  WindowLog (std::string settings, int windows, Shard shard);

  /** \brief Reads the log of a folder. \throws IoError when it is none */
  static WindowLog
  read (const std::string& folder);

  /** \brief Takes what an earlier run of the same shard has finished in a folder;
   * nothing when there is no log. \throws UsageError when the log is of another run */
  void
  resume (const std::string& folder);

  bool
  has (int window) const
  {
    return records_.count (window) > 0;
  }
  void
  add (const WindowRecord& record)
  {
    records_[record.window] = record;
  }
  void
  write (const std::string& folder) const;

  /** \brief By the windows' numbers. */
  const std::map<int, WindowRecord>&
  records () const
  {
    return records_;
  }
  int
  windows () const
  {
    return windows_;
  }
  Shard
  shard () const
  {
    return shard_;
  }

  /** \brief \throws UsageError unless both are of one run \param folder of `other` */
  void
  requireSameRun (const WindowLog& other, const std::string& folder) const;

private:
  std::string settings_;
  int windows_{0};
  Shard shard_;
  std::map<int, WindowRecord> records_;
};

} // namespace pcl_msf::tool
