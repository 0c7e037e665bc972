// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "evaluate_option_table.h"

#include "common/ranges.h"
#include "common/recordings.h"

namespace pcl_msf::tool {

namespace {

Words<std::string>
sameWords (const std::vector<std::string>& words)
{
  Words<std::string> same;
  for (const std::string& word : words)
    same.emplace_back (word, word);
  return same;
}

Words<synthetic::SceneKind>
sceneWords ()
{
  Words<synthetic::SceneKind> words;
  for (const synthetic::SceneKind scene : synthetic::allScenes())
    words.emplace_back (toString (scene), scene);
  return words;
}

void
addSize (CLI::App& app, int& width, int& height)
{
  const auto take = [&width, &height] (const std::string& given) {
    int numbers[2];
    if (!parseList (given, 'x', numbers))
      return false;
    width = numbers[0];
    height = numbers[1];
    return true;
  };
  addOption (app,
             "--size",
             "WxH",
             "pixels",
             take,
             std::to_string (width) + "x" + std::to_string (height));
}

void
addInputOptions (CLI::App& app, EvaluateOptions& o)
{
  beginGroup (app, "What to read");
  addWord<Pairs> (app,
                  "--pairs",
                  "each frame and the next, or frame 0 and each later one",
                  o.pairs,
                  {{"adjacent", Pairs::Adjacent}, {"0-k", Pairs::FromFirst}});
  addNumber (app, "--step", "N", "use every N-th frame", o.step)->check (atLeast (1));
  addNumber (app, "--limit", "N", "pairs of a sequence at the most, 0 = all", o.limit)
      ->check (atLeast (0));
  addCamera (
      app, "pinhole camera in place of the data set's, pixels", o.reading.camera);
  addDepthScale (app,
                 "units per metre of depth in place of the data set's; not for those "
                 "that define it",
                 o.reading.depth_scale);
  addMaxTimeDifference (app,
                        "between colour and depth images of TUM and folders",
                        o.reading.max_time_difference);
  addWord<io::RenderPass> (
      app,
      "--pass",
      "Sintel, FlyingThings3D",
      o.reading.pass,
      {{"clean", io::RenderPass::Clean}, {"final", io::RenderPass::Final}});
  addWord<io::StereoView> (
      app,
      "--view",
      "FlyingThings3D, Virtual KITTI 2",
      o.reading.view,
      {{"left", io::StereoView::Left}, {"right", io::StereoView::Right}});
}

void
addGeneratedOptions (CLI::App& app, GeneratedOptions& g)
{
  beginGroup (app, "What to generate");
  addWords<synthetic::SceneKind> (
      app, "--scenes", "of pcl_msf_synthesize", g.scenes, sceneWords());
  addWords<synthetic::MotionSize> (
      app,
      "--motion",
      "easy, large",
      g.motions,
      {{"easy", synthetic::MotionSize::Easy}, {"large", synthetic::MotionSize::Large}});
  addWords<synthetic::Sensor> (
      app,
      "--sensor",
      "none, kinect",
      g.sensors,
      {{"none", synthetic::Sensor::Ideal}, {"kinect", synthetic::Sensor::Kinect}});
  addNumber (app, "--seed", "N", "of everything", g.seed);
  addSize (app, g.width, g.height);
  addNumber (app, "--frames", "N", "of a sequence", g.frames);
}

void
addRunOptions (CLI::App& app, EvaluateOptions& o)
{
  beginGroup (app, "What to run");
  addOption (
      app,
      "--methods",
      "A,B,...",
      "see below",
      [&o] (const std::string& text) {
        o.methods = splitAtCommas (text);
        return !o.methods.empty();
      },
      o.methods.front());
  addFlag (app,
           "--ablation",
           "add our method with the l1 and l2 norms (the paper's section 4.1)",
           o.ablation);
  addWord<std::string> (app,
                        "--labels",
                        "segments of msf; cut: along true borders",
                        o.labels,
                        sameWords ({"method", "true", "cut"}));
  addWord<std::string> (app,
                        "--start",
                        "motion that msf starts from",
                        o.start,
                        sameWords ({"method", "true"}));
  addNumber (app, "--threads", "N", "of a process, 0 = all", o.threads);
  addOption (app, "--jobs", "N", "gone", [] (const std::string& n) -> bool {
    throw UsageError ("--jobs: gone; GNU parallel runs shards at once: parallel "
                      "pcl_msf_evaluate ... --shard {}/" +
                      n + " --csv part_{}.csv ::: $(seq " + n +
                      "), then pcl_msf_evaluate --merge --csv all.csv part_*.csv");
  })->group ("");
}

void
addOutputOptions (CLI::App& app, EvaluateOptions& o)
{
  beginGroup (app, "What to write");
  auto* csv = addText (
      app,
      "--csv",
      "FILE",
      "a row per method and pair, at once; what is there is not done again; a % "
      "becomes the shard's I",
      o.csv);
  addText (app, "--json", "FILE", "rows and summary", o.json);
  addShard (app, o.shard)->needs (csv);
  addFlag (app, "--merge", "join the CSVs of shards into --csv", o.merge);
  addFlag (app, "--quiet", "no progress on stderr", o.quiet);
}

} // namespace

void
addEvaluateOptions (CLI::App& app, EvaluateOptions& options)
{
  addTexts (app,
            "DATASET",
            "WORD",
            "a data set and its PATH, or generated; with --merge the shards' files",
            options.words);
  addInputOptions (app, options);
  addGeneratedOptions (app, options.generated);
  addRunOptions (app, options);
  addOutputOptions (app, options);
}

} // namespace pcl_msf::tool
