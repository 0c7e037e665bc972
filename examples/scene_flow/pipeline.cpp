// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "pipeline.h"

#include "inputs.h"
#include "interruption.h"
#include "progress_line.h"
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <algorithm>
#include <chrono>
#include <future>

namespace pcl_msf::tool {

namespace {

/** Seconds since it was made, or since the last lap. */
class StopWatch {
public:
  double
  lap ()
  {
    const auto now = Clock::now();
    const std::chrono::duration<double> seconds = now - last_;
    last_ = now;
    return seconds.count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_{Clock::now()};
};

Oversegmentation
segment (const Options& options, const Inputs& inputs, const RgbdFrame& frame)
{
  if (inputs.labels.empty())
    return Oversegmentation::fromFrame (frame, options.segmentation);
  return Oversegmentation::fromLabels (inputs.labels, frame);
}

RgbdFrame
makeFrame (const io::RgbdImages& images, const FrameParameters& parameters)
{
  return RgbdFrame::fromImages (images.color, images.depth, images.camera, parameters);
}

} // namespace

Outcome
runPipeline (const Options& options)
{
  if (options.solver.threads > 0)
    cv::setNumThreads (
        std::min (static_cast<int> (options.solver.threads), cv::getNumberOfCPUs()));
  ProgressLine line (!options.quiet);
  Outcome outcome;
  StopWatch total, watch;
  line.stage ("load");
  Inputs inputs = loadInputs (options);
  outcome.seconds.load = watch.lap();
  throwIfInterrupted();

  line.stage ("frames");
  const auto policy =
      options.solver.threads == 1 ? std::launch::deferred : std::launch::async;
  FrameParameters target = options.frame;
  target.normals = NormalMethod::None;
  auto later = std::async (policy, [&] { return makeFrame (inputs.current, target); });
  const RgbdFrame reference = makeFrame (inputs.reference, options.frame);
  const RgbdFrame current = later.get();
  outcome.seconds.frame = watch.lap();
  throwIfInterrupted();

  line.stage ("segments");
  const Oversegmentation segments = segment (options, inputs, reference);
  outcome.seconds.segment = watch.lap();
  throwIfInterrupted();

  SolverParameters solver = options.solver;
  solver.progress = [&line] (const Progress& progress) {
    line.update (progress);
    return !interrupted();
  };
  const SceneFlowEstimator estimator (options.energy, solver);
  outcome.scene_flow = estimator.estimate (reference, current, segments);
  outcome.seconds.total = total.lap();
  throwIfInterrupted();

  outcome.reference_color = inputs.reference.color;
  outcome.current_color = inputs.current.color;
  outcome.reference_depth = inputs.reference.depth;
  outcome.current_depth = inputs.current.depth;
  return outcome;
}

} // namespace pcl_msf::tool
