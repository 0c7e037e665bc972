// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "run.h"

#include "scene_flow/interruption.h"
#include "work.h"

#include <cstdio>
#include <fstream>

namespace pcl_msf::tool {

ResultFile
evaluateAll (const EvaluateOptions& options)
{
  const std::vector<WorkItem> work = listWork (options);
  ResultFile file{PCL_MSF_VERSION, options.settings(), options.shard, work.size(), {}};
  const PairRunner runner (options);
  if (!options.csv.empty())
    writeResults (options.csv, file);
  for (std::size_t i = 0; i < work.size(); ++i) {
    if (!options.shard.has (i))
      continue;
    throwIfInterrupted();
    const std::vector<Row> rows = runner.run (work[i]);
    std::string text;
    for (const Row& row : rows)
      text += rowText (row);
    if (!options.csv.empty())
      std::ofstream (options.csv, std::ios::app | std::ios::binary)
          << text << std::flush;
    file.rows.insert (file.rows.end(), rows.begin(), rows.end());
    if (!options.quiet)
      std::fprintf (stderr, "[%zu/%zu] %s\n", i + 1, work.size(), work[i].name.c_str());
  }
  return file;
}

} // namespace pcl_msf::tool
