// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <cstddef>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace pcl_msf::tool {

/** \brief A part of the work: every count-th pair, from the index-th on. */
struct Shard {
  int index{1}; ///< 1 .. count
  int count{1};

  bool
  has (std::size_t item) const
  {
    return static_cast<int> (item % static_cast<std::size_t> (count)) == index - 1;
  }

  /** \brief "I/N" */
  std::string
  text () const;
};

/** \brief Reads "I/N", or "auto": from the variables of the launcher, Slurm arrays
 * (SLURM_ARRAY_TASK_ID, _MIN, _STEP, _COUNT), Open MPI (OMPI_COMM_WORLD_RANK, _SIZE),
 * other MPIs (PMI_RANK, PMI_SIZE), srun (SLURM_PROCID, SLURM_NTASKS); or "auto/N" for
 * GNU parallel (PARALLEL_SEQ), which does not tell N. \throws UsageError */
Shard
parseShard (const std::string& text);

/** \brief Adds --shard. */
CLI::Option*
addShard (CLI::App& app, Shard& shard);

} // namespace pcl_msf::tool
