// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "options.h"

#include <pcl/console/print.h>

#include "common/option_values.h"
#include "core/base/number_text.h"
#include "evaluate_option_table.h"
#include "method.h"
#include "score.h"

#include <algorithm>
#include <utility>

namespace pcl_msf::tool {

namespace {

void
takeDataset (const std::vector<std::string>& words, EvaluateOptions& options)
{
  std::vector<std::string> kinds = io::datasetKinds();
  kinds.insert (kinds.end(), {"auto", "generated"});
  std::string list;
  for (const std::string& kind : kinds)
    list += (list.empty() ? "" : ", ") + kind;
  if (words.empty())
    throw UsageError ("no data set; give one of " + list);
  options.dataset = words[0];
  if (std::find (kinds.begin(), kinds.end(), words[0]) == kinds.end())
    throw UsageError ("'" + words[0] + "': no data set; give one of " + list);
  const std::size_t expected = options.dataset == "generated" ? 1 : 2;
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
  if (options.methods.empty()) {
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

void
checkRanges (const EvaluateOptions& options)
{
  if (options.step < 1)
    throw UsageError ("--step: " + std::to_string (options.step) + ", must be >= 1");
  if (options.limit < 0)
    throw UsageError ("--limit: " + std::to_string (options.limit) + ", must be >= 0");
  if (options.jobs < 1 || options.jobs > 1024)
    throw UsageError ("--jobs: " + std::to_string (options.jobs) +
                      ", must be 1 to 1024");
  if (options.shard.count > 1 && options.csv.empty())
    throw UsageError ("--shard: needs --csv, where the shard's rows go");
}

void
printColumns ()
{
  using namespace pcl::console;
  print_info (
      "\nColumns of the CSV, after pair, dataset, sequence, from, to, method (empty = "
      "unknown):\n");
  for (const Column& c : columns()) {
    print_value ("  %-22s", c.name.c_str());
    print_info (" %s\n", c.help);
  }
  print_value ("  %-22s", "motion_*");
  print_info (" dominant motion: rotation vector (rad), translation (m)\n");
  print_value ("  %-22s", "true_motion_*");
  print_info (" that of static points\n");
}

} // namespace

EvaluateOptions
parseEvaluateOptions (int argc, const char* const* argv)
{
  EvaluateOptions options;
  std::vector<std::string> words;
  const auto take_word = [&words] (const std::string& word) { words.push_back (word); };
  readCommandLine (argc, argv, makeEvaluateOptionTable (options), take_word);
  if (options.help)
    return options;
  if (options.merge) {
    options.merged = words;
    if (words.empty())
      throw UsageError ("--merge: no files to merge; give the shards' .csv");
    return options;
  }
  takeDataset (words, options);
  checkRanges (options);
  expandMethods (options);
  options.generated.threads = options.threads;
  return options;
}

std::string
EvaluateOptions::settings() const
{
  std::string text = "dataset=" + dataset;
  if (dataset == "generated") {
    const GeneratedOptions& g = generated;
    text += " size=" + std::to_string (g.width) + "x" + std::to_string (g.height) +
            " frames=" + std::to_string (g.frames) + " seed=" + std::to_string (g.seed);
    for (const Scene scene : g.scenes)
      text += std::string (" ") + toString (scene);
    for (const MotionSize motion : g.motions)
      text += motion == MotionSize::Easy ? " easy" : " large";
    for (const Sensor sensor : g.sensors)
      text += sensor == Sensor::Ideal ? " none" : " kinect";
  }
  else {
    text += " pass=" + reading.pass + " view=" + reading.view;
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
  text += std::string (" pairs=") + (pairs == Pairs::Adjacent ? "adjacent" : "0-k") +
          " step=" + std::to_string (step) + " limit=" + std::to_string (limit) +
          " methods=";
  for (std::size_t i = 0; i < methods.size(); ++i)
    text += (i == 0 ? "" : ",") + methods[i];
  return text;
}

void
printEvaluateHelp (const char* program)
{
  using namespace pcl::console;
  print_info ("Scores our method and baselines on a data set.\n\n");
  print_info ("Syntax: %s DATASET PATH <options>, DATASET one of auto", program);
  for (const std::string& kind : io::datasetKinds())
    print_value (" %s", kind.c_str());
  print_info ("\n    or: %s generated <options>\n", program);
  print_info ("    or: %s --merge --csv OUT.csv SHARD.csv ...\n", program);
  EvaluateOptions defaults;
  printOptions (makeEvaluateOptionTable (defaults));
  print_info ("\nMethods:\n");
  for (const auto& [name, help] : methodHelp()) {
    print_value ("  %-22s", name.c_str());
    print_info (" %s\n", help.c_str());
  }
  printColumns();
}

} // namespace pcl_msf::tool
