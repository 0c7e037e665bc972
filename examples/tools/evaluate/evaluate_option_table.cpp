// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "evaluate_option_table.h"

#include "common/default_help.h"
#include <pcl_msf/errors.h>

#include <sstream>

namespace pcl_msf::tool {

namespace {

using Words = std::vector<std::string>;

Words
splitAtCommas (const std::string& text)
{
  Words words;
  std::istringstream stream (text);
  for (std::string word; std::getline (stream, word, ',');)
    words.push_back (word);
  return words;
}

Setter
word (std::string& value, const Words& words)
{
  return [&value, words] (const std::string& given) {
    for (const std::string& one : words)
      if (one == given) {
        value = given;
        return true;
      }
    return false;
  };
}

/** A list of words out of some, joined by commas. */
template <typename Enum>
Setter
several (std::vector<Enum>& values,
         const std::vector<std::pair<std::string, Enum>>& all)
{
  return [&values, all] (const std::string& given) {
    values.clear();
    for (const std::string& word : splitAtCommas (given))
      if (Enum value{}; choice<Enum> (value, all) (word))
        values.push_back (value);
      else
        return false;
    return !values.empty();
  };
}

Setter
scenes (std::vector<Scene>& values)
{
  std::vector<std::pair<std::string, Scene>> all;
  for (const Scene scene : allScenes())
    all.emplace_back (toString (scene), scene);
  return several (values, all);
}

Setter
size (int& width, int& height)
{
  return [&width, &height] (const std::string& given) {
    int numbers[2];
    if (!parseList (given, 'x', numbers))
      return false;
    width = numbers[0];
    height = numbers[1];
    return true;
  };
}

OptionGroup
inputOptions (EvaluateOptions& o)
{
  return {
      "What to read",
      {{"--pairs",
        "WORD",
        "adjacent or 0-k (frame 0 and each later one) [adjacent]",
        choice<Pairs> (o.pairs,
                       {{"adjacent", Pairs::Adjacent}, {"0-k", Pairs::FromFirst}})},
       numeric ("--step", "N", "use every N-th frame", o.step),
       numeric ("--limit", "N", "pairs of a sequence at the most, 0 = all", o.limit),
       {"--camera",
        "FX,FY,CX,CY",
        "pinhole camera in place of the data set's, pixels",
        camera (o.reading.camera)},
       {"--depth-scale",
        "S",
        "units per metre of depth in place of the data set's; not for those that "
        "define it",
        positive (o.reading.depth_scale)},
       {"--max-time-difference",
        "S",
        withDefault ("between colour and depth images of TUM and folders, seconds",
                     o.reading.max_time_difference),
        positive (o.reading.max_time_difference)},
       {"--pass",
        "WORD",
        "clean or final: Sintel, FlyingThings3D [clean]",
        word (o.reading.pass, {"clean", "final"})},
       {"--view",
        "WORD",
        "left or right: FlyingThings3D, Virtual KITTI 2 [left]",
        word (o.reading.view, {"left", "right"})}}};
}

OptionGroup
generatedOptions (GeneratedOptions& g)
{
  return {"What to generate",
          {{"--scenes", "A,B,...", "of pcl_msf_synthesize [all]", scenes (g.scenes)},
           {"--motion",
            "A,B",
            "easy, large [easy,large]",
            several<MotionSize> (
                g.motions, {{"easy", MotionSize::Easy}, {"large", MotionSize::Large}})},
           {"--sensor",
            "A,B",
            "none, kinect [none,kinect]",
            several<Sensor> (g.sensors,
                             {{"none", Sensor::Ideal}, {"kinect", Sensor::Kinect}})},
           numeric ("--seed", "N", "of everything", g.seed),
           {"--size", "WxH", "pixels [640x480]", size (g.width, g.height)},
           numeric ("--frames", "N", "of a sequence", g.frames)}};
}

OptionGroup
methodOptions (EvaluateOptions& o)
{
  return {"What to run",
          {{"--methods",
            "A,B,...",
            "see below [all]",
            [&o] (const std::string& s) {
              o.methods = splitAtCommas (s);
              return !o.methods.empty();
            }},
           {"--ablation",
            "",
            "add our method with the l1 and l2 norms (the paper's section 4.1)",
            flag (o.ablation)},
           {"--labels",
            "WORD",
            "segments of msf: method, true, or cut along true borders [method]",
            word (o.labels, {"method", "true", "cut"})},
           {"--start",
            "WORD",
            "start of msf: method, or true motion [method]",
            word (o.start, {"method", "true"})},
           numeric ("--threads", "N", "of a process, 0 = all", o.threads),
           numeric ("--jobs", "N", "processes", o.jobs),
           {"--shard",
            "I/N",
            "do the I-th of N parts; auto: as Slurm or MPI says; auto/N: GNU parallel",
            [&o] (const std::string& s) {
              o.shard = parseShard (s);
              return true;
            }}}};
}

OptionGroup
outputOptions (EvaluateOptions& o)
{
  return {"What to write",
          {{"--csv",
            "FILE",
            "a row per method and pair, at once; what is there is not done again",
            text (o.csv)},
           {"--json", "FILE", "rows and summary", text (o.json)},
           {"--merge", "", "join the CSVs of shards into --csv", flag (o.merge)},
           {"--quiet", "", "no progress on stderr", flag (o.quiet)},
           {"--help", "", "print this", flag (o.help)}}};
}

} // namespace

std::vector<OptionGroup>
makeEvaluateOptionTable (EvaluateOptions& options)
{
  return {inputOptions (options),
          generatedOptions (options.generated),
          methodOptions (options),
          outputOptions (options)};
}

} // namespace pcl_msf::tool
