// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "options.h"

#include "cloud_methods.h"
#include "common/camera_effects.h"
#include "common/command_line.h"
#include "common/methods/method.h"
#include "common/tuning_options.h"
#include "core/base/number_text.h"
#include "core/base/tuning/tuning.h"
#include "evaluate_option_table.h"
#include "score.h"
#include <CLI/App.hpp>

#include <algorithm>
#include <utility>

namespace pcl_msf::tool {

namespace {

void
takeDataset (const std::vector<std::string>& words, EvaluateOptions& options)
{
  std::vector<std::string> kinds;
  for (const auto& kind : io::datasetKinds())
    kinds.push_back (kind.first);
  kinds.insert (kinds.end(), {"auto", "generated", kClouds, kBodies});
  std::string list;
  for (const std::string& kind : kinds)
    list += (list.empty() ? "" : ", ") + kind;
  if (words.empty())
    throw UsageError ("no data set; give one of " + list);
  options.dataset = words[0];
  if (std::find (kinds.begin(), kinds.end(), words[0]) == kinds.end())
    throw UsageError ("'" + words[0] + "': no data set; give one of " + list);
  const bool made = options.dataset == "generated" || options.dataset == kBodies;
  const std::size_t expected = made ? 1 : 2;
  if (words.size() < expected)
    throw UsageError (words[0] + ": needs a path; give the data set's folder after it");
  if (words.size() > expected)
    throw UsageError ("'" + words[expected] +
                      "': one word too many; give a data set and a path");
  if (expected == 2)
    options.path = words[1];
}

/** Applies --labels, --start and --ablation to the list of methods. */
void
expandMethods (EvaluateOptions& options)
{
  if (options.methods == std::vector<std::string>{kAllMethods}) {
    options.methods.clear();
    for (const auto& [name, help] : methodHelp())
      if (name.find (':') == std::string::npos)
        options.methods.push_back (name);
    if (options.ablation)
      options.methods = {"msf"};
  }
  if (options.ablation)
    for (const char* variant : {"msf:loss=l1", "msf:loss=l2"})
      options.methods.emplace_back (variant);
  std::string extra;
  if (options.labels != "method")
    extra += ":labels=" + options.labels;
  if (options.start != "method")
    extra += ":start=" + options.start;
  for (std::string& method : options.methods)
    if (method == "msf" || method.rfind ("msf:", 0) == 0)
      method += extra;
  std::vector<std::string> sorted = options.methods;
  std::sort (sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find (sorted.begin(), sorted.end());
  if (twice != sorted.end())
    throw UsageError ("--methods: '" + *twice + "' is given twice; leave one away");
  for (const std::string& method : options.methods)
    makeMethod (method, options.threads);
}

/** Clouds without a grid have methods of their own. */
void
takeCloudMethods (EvaluateOptions& options)
{
  std::vector<std::string> known;
  for (const auto& [name, help] : cloudMethodHelp())
    known.push_back (name);
  if (options.methods == std::vector<std::string>{kAllMethods})
    options.methods = known;
  for (const std::string& method : options.methods)
    if (std::find (known.begin(), known.end(), method) == known.end())
      throw UsageError ("--methods: '" + method +
                        "' is none for clouds without a grid; they are zero, icp, gicp "
                        "and msf");
  if (options.ablation)
    throw UsageError (options.dataset +
                      ": --ablation is not for clouds without a grid; leave it away");
}

void
check (EvaluateOptions& options)
{
  if (options.merge) {
    options.merged = options.words;
    if (options.merged.empty())
      throw UsageError ("--merge: no files to merge; give the shards' .csv");
    return;
  }
  if (const std::size_t at = options.csv.find ('%'); at != std::string::npos)
    options.csv.replace (at, 1, std::to_string (options.shard.index));
  takeDataset (options.words, options);
  if (isOfClouds (options))
    return takeCloudMethods (options);
  expandMethods (options);
  options.generated.threads = options.threads;
  options.generated.distortion = options.reading.distortion;
}

/** A name and what it is, as lines of the help. */
std::string
helpLine (const std::string& name, const std::string& help)
{
  return "  " + name + std::string (std::max<std::size_t> (1, 24 - name.size()), ' ') +
         help + "\n";
}

std::string
footer ()
{
  std::string text = "DATASET is one of auto";
  for (const auto& kind : io::datasetKinds())
    text += ", " + kind.first;
  text += ", generated; without a grid: clouds (FOLDER has folders with source.ply, "
          "target.ply and truth.ply) or bodies (generated).\n\nMethods for clouds "
          "without a grid:\n";
  for (const auto& [name, help] : cloudMethodHelp())
    text += helpLine (name, help);
  text += "\nMethods:\n";
  for (const auto& [name, help] : methodHelp())
    text += helpLine (name, help);
  text +=
      "\nColumns of the CSV, after pair, dataset, sequence, from, to, method (empty "
      "= unknown):\n";
  for (const Column& c : columns())
    text += helpLine (c.name, c.help);
  text +=
      helpLine ("motion_*", "dominant motion: rotation vector (rad), translation (m)");
  return text + helpLine ("true_motion_*", "that of static points");
}

} // namespace

void
declareOptions (CLI::App& app, EvaluateOptions& options)
{
  addEvaluateOptions (app, options);
  addTuningOptions (app);
  app.footer (footer);
  app.final_callback ([&options] { check (options); });
}

std::string
EvaluateOptions::settings() const
{
  std::string text = "dataset=" + dataset;
  if (dataset == "generated") {
    const GeneratedOptions& g = generated;
    text += " size=" + std::to_string (g.width) + "x" + std::to_string (g.height) +
            " frames=" + std::to_string (g.frames) + " seed=" + std::to_string (g.seed);
    if (g.noise_seeds > 1)
      text += " noise_seeds=" + std::to_string (g.noise_seeds);
    for (const synthetic::SceneKind scene : g.scenes)
      text += std::string (" ") + toString (scene);
    for (const synthetic::MotionSize motion : g.motions)
      text += motion == synthetic::MotionSize::Easy ? " easy" : " large";
    for (const synthetic::Sensor sensor : g.sensors)
      text += std::string (" ") + toString (sensor);
    text += " sensor_models=2"; // 0.1.0's kinect is white
    text += effectsText (g.effects) + (g.motion_blur ? " blur" : "");
  }
  else {
    text += std::string (" pass=") + toString (reading.pass) +
            " view=" + toString (reading.view);
    if (reading.camera)
      for (const double value : {reading.camera->fx,
                                 reading.camera->fy,
                                 reading.camera->cx,
                                 reading.camera->cy})
        text += " " + fixedText (value, 6);
    if (reading.depth_scale)
      text += " depth_scale=" + fixedText (*reading.depth_scale, 6);
    if (reading.max_time_difference != io::DatasetOptions().max_time_difference)
      text += " max_time_difference=" + fixedText (reading.max_time_difference, 6);
  }
  if (reading.distortion)
    text += " distortion=" + distortionText (*reading.distortion);
  text += std::string (" pairs=") + (pairs == Pairs::Adjacent ? "adjacent" : "0-k") +
          " step=" + std::to_string (step) + " limit=" + std::to_string (limit) +
          " methods=";
  for (std::size_t i = 0; i < methods.size(); ++i)
    text += (i == 0 ? "" : ",") + methods[i];
  for (const auto& [name, value] : changedTuning())
    text += " " + name + "=" + value;
  return text;
}

} // namespace pcl_msf::tool
