// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "options.h"

#include "common/tuning_options.h"
#include "option_table.h"
#include <CLI/App.hpp>

#include <filesystem>

namespace pcl_msf::tool {

namespace {

void
checkCount (const char* name, std::size_t count, std::size_t wanted)
{
  const std::string given =
      std::string (name) + ": given " + std::to_string (count) + " times; ";
  if (count < 2)
    throw UsageError (given + "give it twice or more, in the order of time");
  if (count != wanted)
    throw UsageError (given + "give it once a frame, as --depth");
}

void
checkFiles (const Options& options)
{
  if (options.cloud.empty()) {
    checkCount ("--depth", options.depth.size(), options.depth.size());
    if (!options.color.empty())
      checkCount ("--color", options.color.size(), options.depth.size());
    if (!options.camera)
      throw UsageError ("--camera: missing; give FX,FY,CX,CY in pixels");
  }
  else
    checkCount ("--cloud", options.cloud.size(), options.cloud.size());
  if (options.output.empty())
    throw UsageError ("--output: missing; give a folder for the results");
}

void
checkInputs (const Options& options)
{
  const bool files =
      !options.color.empty() || !options.depth.empty() || !options.cloud.empty();
  if (options.sequence.empty())
    checkFiles (options);
  else if (files)
    throw UsageError (
        "'" + options.sequence +
        "': not together with --color, --depth or --cloud; give the folder or "
        "files");
  if (options.window < 0 || options.window == 1)
    throw UsageError ("--window: " + std::to_string (options.window) +
                      ", must be 0 or at least 2");
  if (options.track && options.window > 16)
    throw UsageError ("--window: " + std::to_string (options.window) +
                      ", must be at most 16 with --track");
}

/** Of files and folders the place, however it was spelled. */
std::string
settingText (const std::string& name, const std::string& value)
{
  namespace fs = std::filesystem;
  const bool is_path = name == "FOLDER" || name == "--color" || name == "--depth" ||
                       name == "--cloud" || name == "--labels";
  if (!is_path)
    return value;
  std::error_code error;
  const fs::path place = fs::weakly_canonical (fs::absolute (value), error);
  return error ? value : place.string();
}

/** All that was given, but where and how the run works. */
std::string
settingsOf (const CLI::App& app)
{
  std::string text;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || name == "--output" || name == "--shard" ||
        name == "--quiet" || name == "--threads")
      continue;
    text += (text.empty() ? "" : " ") + name;
    for (const std::string& value : option->results())
      text += " " + settingText (name, value);
  }
  return text;
}

} // namespace

void
declareOptions (CLI::App& app, Options& options)
{
  addSceneFlowOptions (app, options);
  addTuningOptions (app);
  app.final_callback ([&app, &options] {
    if (options.merge) {
      if (options.output.empty())
        throw UsageError ("--merge: needs --output, the folder of the shards");
      return;
    }
    options.shard_given = app.count ("--shard") > 0;
    options.settings = settingsOf (app);
    checkInputs (options);
    checkSettings (app, options);
  });
}

} // namespace pcl_msf::tool
