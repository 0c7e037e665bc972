// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
//
// Every stage and the whole, over the number of pixels, segments, frames and threads,
// on generated pairs; kernels alone. Options of Google Benchmark choose and write JSON.
#include "kernel_scene.h"
#include <benchmark/benchmark.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <pcl_msf/scene_flow_tracker.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <map>

namespace {

using namespace pcl_msf;
using benchmark::State;

/** Frames of a generated scene, rendered once for all benchmarks of a size. */
const synthetic::SyntheticSequence&
sequenceOf (int width)
{
  static std::map<int, synthetic::SyntheticSequence> made;
  auto found = made.find (width);
  if (found == made.end()) {
    synthetic::SequenceOptions options;
    options.sensor = synthetic::Sensor::Kinect;
    options.width = width;
    options.height = width * 3 / 4;
    options.frames = 4;
    found = made.emplace (width, synthetic::synthesize (options)).first;
  }
  return found->second;
}

RgbdFrame
makeFrame (int width, int k)
{
  const synthetic::SyntheticSequence& sequence = sequenceOf (width);
  return RgbdFrame::fromImages (
      sequence.frames[k].color, sequence.frames[k].depth, sequence.camera);
}

std::vector<RgbdFrame>
makeFrames (int width, int count)
{
  std::vector<RgbdFrame> frames;
  for (int k = 0; k < count; ++k)
    frames.push_back (makeFrame (width, k));
  return frames;
}

void
countPixels (State& state, int width)
{
  state.SetItemsProcessed (state.iterations() * width * (width * 3 / 4));
}

void
Frame (State& state)
{
  const int width = static_cast<int> (state.range (0));
  sequenceOf (width);
  for (auto _ : state)
    benchmark::DoNotOptimize (makeFrame (width, 0));
  countPixels (state, width);
}

void
Segments (State& state)
{
  const int width = static_cast<int> (state.range (0));
  const RgbdFrame frame = makeFrame (width, 0);
  for (auto _ : state)
    benchmark::DoNotOptimize (Oversegmentation::fromFrame (
        frame, {}, static_cast<unsigned> (state.range (1))));
  countPixels (state, width);
}

/** A stage of the solve as the report tells it; none = all of it. */
void
Pair (State& state, double Report::*stage)
{
  const int width = static_cast<int> (state.range (0));
  SolverParameters solver;
  solver.threads = static_cast<unsigned> (state.range (1));
  SegmentationParameters segmentation;
  segmentation.segment_size = static_cast<int> (state.range (2));
  const std::vector<RgbdFrame> frames = makeFrames (width, 2);
  const Oversegmentation segments =
      Oversegmentation::fromFrame (frames[0], segmentation, solver.threads);
  const SceneFlowEstimator estimator ({}, solver);
  for (auto _ : state) {
    const Report report = estimator.estimate (frames[0], frames[1], segments).report;
    state.SetIterationTime (stage != nullptr
                                ? report.*stage
                                : report.start_seconds + report.solve_seconds +
                                      report.result_seconds);
  }
  state.counters["segments"] = segments.size();
  countPixels (state, width);
}

void
Window (State& state)
{
  SolverParameters solver;
  solver.threads = static_cast<unsigned> (state.range (1));
  const std::vector<RgbdFrame> frames =
      makeFrames (640, static_cast<int> (state.range (0)));
  const Oversegmentation segments =
      Oversegmentation::fromFrame (frames[0], {}, solver.threads);
  const MultiframeEstimator estimator ({}, solver);
  for (auto _ : state)
    benchmark::DoNotOptimize (estimator.estimate (frames, 0, segments));
}

/** One more frame for a tracker that goes there and back again. */
void
Follow (State& state)
{
  const int width = static_cast<int> (state.range (0));
  SolverParameters solver;
  solver.threads = static_cast<unsigned> (state.range (1));
  const std::vector<RgbdFrame> frames = makeFrames (width, 4);
  SceneFlowTracker tracker ({}, {}, {}, solver, {});
  const int order[] = {0, 1, 2, 3, 2, 1};
  int step = 0;
  tracker.add (frames[order[step++]]);
  for (auto _ : state)
    tracker.add (frames[order[step++ % 6]]);
  countPixels (state, width);
}

using KernelFunction =
    kernel::Sums (benchmarks::KernelScene::*) (const kernel::Kernel&);

void
Kernel (State& state,
        const kernel::Kernel& kernel,
        KernelFunction function,
        const benchmarks::KernelWork& work)
{
  const int width = static_cast<int> (state.range (0));
  benchmarks::KernelScene scene (width, width * 3 / 4);
  for (auto _ : state)
    benchmark::DoNotOptimize ((scene.*function) (kernel));
  state.SetItemsProcessed (state.iterations() * scene.points());
  state.SetBytesProcessed (static_cast<std::int64_t> (
      work.bytes * static_cast<double> (state.iterations() * scene.points())));
}

void
registerPairs ()
{
  const std::pair<const char*, double Report::*> stages[] = {
      {"Pair/start", &Report::start_seconds},
      {"Pair/solve", &Report::solve_seconds},
      {"Pair/result", &Report::result_seconds},
      {"Pair/all", nullptr}};
  for (const auto& [name, stage] : stages) {
    auto* pair = benchmark::RegisterBenchmark (name, Pair, stage);
    pair->ArgNames ({"width", "threads", "side"});
    pair->ArgsProduct ({{320, 640, 1280}, {1, 2}, {24}});
    if (stage == nullptr)
      pair->ArgsProduct ({{640}, {1}, {48, 34, 17, 12}});
    pair->UseManualTime()->Unit (benchmark::kMillisecond);
  }
}

void
registerKernels ()
{
  using benchmarks::KernelScene;
  for (const kernel::Kernel& k : kernel::usableKernels()) {
    const std::string name = k.name;
    for (auto* one : {benchmark::RegisterBenchmark (("Linearize/" + name).c_str(),
                                                    Kernel,
                                                    k,
                                                    &KernelScene::linearize,
                                                    benchmarks::kLinearizeWork),
                      benchmark::RegisterBenchmark (("Probe/" + name).c_str(),
                                                    Kernel,
                                                    k,
                                                    &KernelScene::probe,
                                                    benchmarks::kProbeWork)})
      one->ArgName ("width")->Arg (320)->Arg (640)->Arg (1280)->Unit (
          benchmark::kMillisecond);
  }
}

} // namespace

BENCHMARK (Frame)
    ->ArgName ("width")
    ->Arg (320)
    ->Arg (640)
    ->Arg (1280)
    ->Unit (benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK (Segments)
    ->ArgNames ({"width", "threads"})
    ->ArgsProduct ({{320, 640, 1280}, {1, 2}})
    ->Unit (benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK (Window)
    ->ArgNames ({"frames", "threads"})
    ->ArgsProduct ({{2, 3, 4}, {1, 2}})
    ->Unit (benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK (Follow)
    ->ArgNames ({"width", "threads"})
    ->ArgsProduct ({{320, 640}, {1, 2}})
    ->Unit (benchmark::kMillisecond)
    ->UseRealTime();

int
main (int argc, char** argv)
{
  registerPairs();
  registerKernels();
  benchmark::Initialize (&argc, argv);
  if (benchmark::ReportUnrecognizedArguments (argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
