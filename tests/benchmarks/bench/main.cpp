// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// What a pair costs, beside what others cost on the same pair and machine.
#include "bench/bench_report.h"
#include "bench/machine_speed.h"
#include "common/command_line.h"
#include "common/tool_main.h"
#include <CLI/App.hpp>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/io/text_files.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>
#include <sched.h>

#include <cstdio>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::benchmarks;

struct BenchOptions {
  std::string path; ///< of a data set; empty = a generated pair
  synthetic::SequenceOptions generated;
  MeasureOptions measure;
  bool no_kernels{false};
  std::string json;
};

bool
parseSize (const std::string& text, synthetic::SequenceOptions& sequence)
{
  int size[2];
  if (!tool::parseList (text, 'x', size))
    return false;
  sequence.width = size[0];
  sequence.height = size[1];
  return true;
}

bool
parseThreads (const std::string& text, std::vector<unsigned>& threads)
{
  threads.clear();
  for (const std::string& word : tool::splitAtCommas (text))
    if (!tool::parse (word, threads.emplace_back()) || threads.back() < 1)
      return false;
  return !threads.empty();
}

void
declareOptions (CLI::App& app, BenchOptions& o)
{
  o.generated.sensor = synthetic::Sensor::Kinect;
  tool::addText (app,
                 "PATH",
                 "FOLDER",
                 "frames 0 and 1 of a data set's first sequence [a generated pair]",
                 o.path);
  tool::addOption (
      app,
      "--size",
      "WxH",
      "of the generated pair",
      [&o] (const std::string& text) { return parseSize (text, o.generated); },
      "640x480");
  tool::addNumber (app, "--seed", "N", "of the generated pair", o.generated.seed);
  tool::addOption (
      app,
      "--methods",
      "A,B,...",
      "those of pcl_msf_evaluate",
      [&o] (const std::string& text) {
        o.measure.methods = tool::splitAtCommas (text);
        return !o.measure.methods.empty();
      },
      "msf,rigid,dis_medium,tvl1,gicp");
  tool::addOption (
      app,
      "--threads",
      "N,M,...",
      "numbers of threads",
      [&o] (const std::string& text) { return parseThreads (text, o.measure.threads); },
      "1,2");
  tool::addNumber (app, "--repetitions", "N", "runs of each", o.measure.repetitions);
  tool::addNumber (app,
                   "--most-seconds",
                   "S",
                   "of one method with one number of threads",
                   o.measure.most_seconds);
  tool::addFlag (app, "--no-kernels", "leave out the kernels' table", o.no_kernels);
  tool::addText (app, "--json", "FILE", "the same numbers as JSON", o.json);
}

tool::PairData
recordedPair (const std::string& path, std::string& name)
{
  const auto sequence = io::openDataset (io::DatasetKind::Automatic, path, {}).front();
  if (sequence->frames() < 2)
    throw InvalidInput (path + ": " + sequence->name() +
                        " has one frame; a pair needs two");
  name = sequence->name();
  return {sequence->frame (0), sequence->frame (1), {}, {}};
}

tool::PairData
generatedPair (const synthetic::SequenceOptions& options, std::string& name)
{
  const synthetic::SyntheticSequence sequence = synthetic::synthesize (options);
  name = std::string ("generated ") + toString (options.scene) + ", " +
         toString (options.sensor) + ", seed " + std::to_string (options.seed);
  const auto images = [&] (int k) {
    return io::RgbdImages{
        sequence.frames[k].color, sequence.frames[k].depth, sequence.camera};
  };
  return {images (0), images (1), {}, {}};
}

unsigned
usableProcessors ()
{
  cpu_set_t set;
  if (sched_getaffinity (0, sizeof set, &set) != 0)
    return 0;
  return static_cast<unsigned> (CPU_COUNT (&set));
}

int
run (const BenchOptions& o)
{
  if (o.measure.repetitions < 1)
    throw tool::UsageError ("--repetitions: must be at least 1");
  for (const std::string& method : o.measure.methods)
    tool::makeMethod (method, 1); // unknown ones are told at once
  BenchReport report;
  const tool::PairData pair = o.path.empty() ? generatedPair (o.generated, report.pair)
                                             : recordedPair (o.path, report.pair);
  report.width = pair.reference.depth.cols;
  report.height = pair.reference.depth.rows;
  report.processor = processorName();
  report.processors = usableProcessors();
  report.methods = measure (pair, o.measure);
  if (!o.no_kernels)
    report.kernels = kernelSpeeds (report.width, report.height);
  std::fputs (tableText (report).c_str(), stdout);
  if (!o.json.empty())
    io::writeText (o.json, jsonText (report));
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return tool::toolMain<BenchOptions> (
      {"pcl_msf_bench",
       "Seconds and memory of a pair, by stage and threads, beside optical flow,\n"
       "GICP and one rigid motion on the same pair; what the kernels reach.",
       declareOptions,
       run,
       false},
      argc,
      argv);
}
