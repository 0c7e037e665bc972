// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/shard.h"

#include "common/command_line.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace pcl_msf::tool {

namespace {

std::optional<int>
variable (const char* name)
{
  const char* text = std::getenv (name);
  if (text == nullptr)
    return std::nullopt;
  int value = 0;
  if (!parse (text, value))
    throw UsageError (std::string ("--shard auto: ") + name + "='" + text +
                      "' is no number; give I/N");
  return value;
}

/** The index, from 0 on, and the number, where the launcher tells it. */
struct Place {
  int index;
  std::optional<int> count;
};

std::optional<Place>
placeFromLauncher ()
{
  if (const auto id = variable ("SLURM_ARRAY_TASK_ID"))
    return Place{(*id - variable ("SLURM_ARRAY_TASK_MIN").value_or (0)) /
                     std::max (1, variable ("SLURM_ARRAY_TASK_STEP").value_or (1)),
                 variable ("SLURM_ARRAY_TASK_COUNT")};
  if (const auto rank = variable ("OMPI_COMM_WORLD_RANK"))
    return Place{*rank, variable ("OMPI_COMM_WORLD_SIZE")};
  if (const auto rank = variable ("PMI_RANK"))
    return Place{*rank, variable ("PMI_SIZE")};
  const auto tasks = variable ("SLURM_NTASKS"); // srun; a batch script alone is one
  if (const auto id = variable ("SLURM_PROCID"); id && tasks.value_or (1) > 1)
    return Place{*id, tasks};
  if (const auto sequence = variable ("PARALLEL_SEQ"))
    return Place{*sequence - 1, std::nullopt};
  return std::nullopt;
}

Shard
fromLauncher (std::optional<int> count)
{
  const auto place = placeFromLauncher();
  if (!place)
    throw UsageError ("--shard auto: no variable of Slurm arrays, GNU parallel or MPI "
                      "is set; give I/N");
  if (!count)
    count = place->count;
  if (!count)
    throw UsageError ("--shard auto: this launcher does not tell the number of shards; "
                      "give auto/N");
  return {place->index + 1, *count};
}

} // namespace

std::string
Shard::text() const
{
  return std::to_string (index) + "/" + std::to_string (count);
}

Shard
parseShard (const std::string& text)
{
  const std::size_t slash = std::min (text.find ('/'), text.size());
  const std::string first = text.substr (0, slash);
  Shard shard;
  std::optional<int> count;
  if (slash < text.size() && !parse (text.substr (slash + 1), count.emplace()))
    throw UsageError ("--shard: '" + text +
                      "' is neither I/N nor auto; give for example 1/4");
  if (first == "auto")
    shard = fromLauncher (count);
  else if (count && parse (first, shard.index))
    shard.count = *count;
  else
    throw UsageError ("--shard: '" + text +
                      "' is neither I/N nor auto; give for example 1/4");
  if (shard.count < 1 || shard.index < 1 || shard.index > shard.count)
    throw UsageError ("--shard: " + shard.text() + " is none of 1/N to N/N");
  return shard;
}

CLI::Option*
addShard (CLI::App& app, Shard& shard)
{
  const auto take = [&shard] (const std::string& text) {
    shard = parseShard (text);
    return true;
  };
  return addOption (
      app,
      "--shard",
      "I/N",
      "do the I-th of N parts; auto: as Slurm or MPI says; auto/N: GNU parallel",
      take);
}

} // namespace pcl_msf::tool
