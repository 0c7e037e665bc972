// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "result_store.h"

#include "common/command_line.h"
#include <fcntl.h>
#include <pcl_msf/errors.h>
#include <unistd.h>

#include <filesystem>

namespace pcl_msf::tool {

namespace {

/** The rows of one pair in the order of the methods; nothing unless all are there. */
std::vector<Row>
complete (const std::vector<Row>& rows, const std::vector<std::string>& methods)
{
  std::vector<Row> sorted;
  for (const std::string& method : methods)
    for (const Row& row : rows)
      if (row.method == method) {
        sorted.push_back (row);
        break;
      }
  if (sorted.size() != methods.size())
    sorted.clear();
  return sorted;
}

} // namespace

void
requireSameRun (const std::string& path, const ResultFile& found, const ResultFile& run)
{
  const std::string remedy = "; give another --csv, or remove the file";
  if (found.version != run.version)
    throw UsageError (path + ": written by version " + found.version + ", this is " +
                      run.version + remedy);
  if (found.settings != run.settings)
    throw UsageError (path + ": holds a run of other settings (" + found.settings +
                      ")" + remedy);
  if (found.shard.text() != run.shard.text())
    throw UsageError (path + ": holds shard " + found.shard.text() + ", this is " +
                      run.shard.text() + remedy);
  if (found.pairs != run.pairs)
    throw UsageError (path + ": holds a run of " + std::to_string (found.pairs) +
                      " pairs, the data set has " + std::to_string (run.pairs) +
                      remedy);
}

void
appendToDisk (const std::string& path, const std::string& text)
{
  const int file = open (path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  bool good = file >= 0;
  // One write: rows of one pair stay together.
  good = good &&
         write (file, text.data(), text.size()) == static_cast<ssize_t> (text.size());
  good = good && fsync (file) == 0;
  if (file >= 0)
    close (file);
  if (!good)
    throw IoError (path + ": cannot be written; check that it may be written to and "
                          "that there is space");
}

ResultStore::ResultStore (std::string path,
                          ResultFile head,
                          const std::vector<WorkItem>& work,
                          const std::vector<std::string>& methods)
: path_ (std::move (path)), head_ (std::move (head)), pairs_ (work.size())
{
  if (path_.empty())
    return;
  if (std::filesystem::exists (path_))
    resume (work, methods);
  writeResults (path_, inOrder());
}

void
ResultStore::resume (const std::vector<WorkItem>& work,
                     const std::vector<std::string>& methods)
{
  const ResultFile found = readResults (path_);
  requireSameRun (path_, found, head_);
  for (const Row& row : found.rows) {
    if (row.pair >= work.size() || work[row.pair].name != row.sequence ||
        work[row.pair].from != row.from || work[row.pair].to != row.to)
      throw UsageError (path_ + ": pair " + std::to_string (row.pair) + " (" +
                        row.sequence +
                        ") is another one in this data set; give "
                        "another --csv, or remove the file");
    pairs_[row.pair].push_back (row);
  }
  for (std::vector<Row>& rows : pairs_)
    rows = complete (rows, methods);
}

void
ResultStore::add (const std::vector<Row>& rows)
{
  std::string text;
  for (const Row& row : rows)
    text += rowText (row);
  if (!path_.empty())
    appendToDisk (path_, text);
  pairs_.at (rows.at (0).pair) = rows;
}

ResultFile
ResultStore::inOrder() const
{
  ResultFile file = head_;
  for (const std::vector<Row>& rows : pairs_)
    file.rows.insert (file.rows.end(), rows.begin(), rows.end());
  return file;
}

ResultFile
ResultStore::finish()
{
  ResultFile file = inOrder();
  if (!path_.empty())
    writeResults (path_, file);
  return file;
}

} // namespace pcl_msf::tool
