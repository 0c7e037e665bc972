// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "merge.h"

#include "common/command_line.h"

#include <algorithm>
#include <map>

namespace pcl_msf::tool {

namespace {

struct Source {
  std::string path;
  ResultFile file;
};

void
requireOneRun (const std::vector<Source>& sources)
{
  const Source& first = sources.front();
  for (const Source& other : sources) {
    const std::string both = first.path + " and " + other.path + ": ";
    if (other.file.version != first.file.version)
      throw UsageError (both + "different versions, " + first.file.version + " and " +
                        other.file.version + "; run them with one");
    if (other.file.settings != first.file.settings ||
        other.file.pairs != first.file.pairs)
      throw UsageError (both + "different settings: '" + first.file.settings + "', '" +
                        other.file.settings + "'; they are no shards of one run");
    if (other.file.shard.count != first.file.shard.count)
      throw UsageError (both + "shards " + first.file.shard.text() + " and " +
                        other.file.shard.text() +
                        " are not of one division; run all with one N");
  }
}

/** Which file each pair is from. */
std::map<std::size_t, const Source*>
findPairs (const std::vector<Source>& sources)
{
  std::map<std::size_t, const Source*> origin;
  for (const Source& source : sources)
    for (const Row& row : source.file.rows) {
      const auto [at, is_new] = origin.emplace (row.pair, &source);
      if (!is_new && at->second != &source)
        throw UsageError (at->second->path + " and " + source.path + ": pair " +
                          std::to_string (row.pair) + " (" + row.sequence +
                          ") is in both; give each shard once");
    }
  return origin;
}

std::vector<std::string>
findMissing (const std::vector<Source>& sources,
             const std::map<std::size_t, const Source*>& origin)
{
  const ResultFile& any = sources.front().file;
  std::vector<std::string> missing;
  for (int i = 1; i <= any.shard.count; ++i) {
    const Shard shard{i, any.shard.count};
    std::size_t expected = 0, found = 0;
    for (std::size_t pair = 0; pair < any.pairs; ++pair)
      if (shard.has (pair)) {
        ++expected;
        found += origin.count (pair);
      }
    if (found < expected)
      missing.push_back ("shard " + shard.text() + ": " +
                         std::to_string (expected - found) + " of " +
                         std::to_string (expected) + " pairs");
  }
  return missing;
}

} // namespace

Merged
mergeResults (const std::vector<std::string>& paths)
{
  std::vector<Source> sources;
  for (const std::string& path : paths)
    sources.push_back ({path, readResults (path)});
  requireOneRun (sources);
  Merged merged;
  merged.missing = findMissing (sources, findPairs (sources));
  merged.results = sources.front().file;
  merged.results.shard = {};
  merged.results.rows.clear();
  for (const Source& source : sources)
    merged.results.rows.insert (
        merged.results.rows.end(), source.file.rows.begin(), source.file.rows.end());
  std::stable_sort (merged.results.rows.begin(),
                    merged.results.rows.end(),
                    [] (const Row& a, const Row& b) { return a.pair < b.pair; });
  return merged;
}

} // namespace pcl_msf::tool
