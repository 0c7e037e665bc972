// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pair_table.h"
#include "work.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief \throws UsageError unless a file holds results of the run that it is to hold
 */
void
requireSameRun (const std::string& path,
                const ResultFile& found,
                const ResultFile& run);

/** \brief Keeps the rows of a run, in memory and, when there is a path, in a CSV to
 * which each finished pair is added at once. A run that was killed goes on where it
 * was: pairs that the CSV holds with all methods are not done again. */
class ResultStore {
public:
  /** \param head of the run, without rows \param work of all shards
   * \param methods that a finished pair has rows of
   * \throws UsageError when the file holds another run; IoError when it is damaged or
   * cannot be written */
  ResultStore (std::string path,
               ResultFile head,
               const std::vector<WorkItem>& work,
               const std::vector<std::string>& methods);

  /** \brief Is this pair finished? */
  bool
  has (std::size_t pair) const
  {
    return !pairs_.at (pair).empty();
  }

  /** \brief Adds a finished pair, to the disk as well. \throws IoError */
  void
  add (const std::vector<Row>& rows);

  /** \brief Everything in the order of the work; writes it to the file that way. */
  ResultFile
  finish ();

private:
  void
  resume (const std::vector<WorkItem>& work, const std::vector<std::string>& methods);
  ResultFile
  inOrder () const;

  std::string path_;
  ResultFile head_;
  std::vector<std::vector<Row>> pairs_;
};

/** \brief Appends to a file and waits until it is on the disk. \throws IoError */
void
appendToDisk (const std::string& path, const std::string& text);

} // namespace pcl_msf::tool
