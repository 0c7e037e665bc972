// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "pipeline.h"

#include "common/interruption.h"
#include "common/progress_line.h"
#include "common/stop_watch.h"
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>

#include <algorithm>
#include <future>
#include <numeric>

namespace pcl_msf::tool {

namespace {

Oversegmentation
segment (const Options& options, const Inputs& inputs, const RgbdFrame& frame)
{
  const cv::Mat labels = inputs.labels (frame.inputInverseDepth().size());
  if (labels.empty())
    return Oversegmentation::fromFrame (
        frame, options.segmentation, options.solver.threads);
  return Oversegmentation::fromLabels (labels, frame);
}

/** All frames; the outermost are targets only and need no normals. */
std::vector<RgbdFrame>
makeFrames (const Options& options,
            const std::vector<io::RgbdImages>& images,
            int reference)
{
  const auto policy =
      options.solver.threads == 1 ? std::launch::deferred : std::launch::async;
  const int count = static_cast<int> (images.size());
  std::vector<std::future<RgbdFrame>> later;
  for (int k = 0; k < count; ++k) {
    FrameParameters parameters = options.frame;
    if (k != reference && (k == 0 || k == count - 1))
      parameters.normals = NormalMethod::Skip;
    later.push_back (std::async (policy, [&images, k, parameters] {
      return RgbdFrame::fromImages (
          images[k].color, images[k].depth, images[k].camera, parameters);
    }));
  }
  std::vector<RgbdFrame> frames;
  for (auto& frame : later)
    frames.push_back (frame.get());
  return frames;
}

} // namespace

int
Outcome::lastTarget() const
{
  const int last = static_cast<int> (result.frames.size()) - 1;
  return result.reference == last ? last - 1 : last;
}

Outcome
runPipeline (const Options& options, Inputs& inputs, int first, int count)
{
  limitThreads (options);
  ProgressLine line (!options.quiet);
  Outcome outcome;
  outcome.indices.resize (count);
  std::iota (outcome.indices.begin(), outcome.indices.end(), first);
  StopWatch total, watch;
  line.stage ("load");
  outcome.images = inputs.load (first, count);
  outcome.seconds.load = watch.lap();
  throwIfInterrupted();

  line.stage ("frames");
  const int reference = std::min (options.reference, count - 1);
  const std::vector<RgbdFrame> frames = makeFrames (options, outcome.images, reference);
  outcome.seconds.frame = watch.lap();
  throwIfInterrupted();

  line.stage ("segments");
  const Oversegmentation segments = segment (options, inputs, frames[reference]);
  outcome.seconds.segment = watch.lap();
  throwIfInterrupted();

  SolverParameters solver = options.solver;
  solver.progress = [&line] (const Progress& progress) {
    line.update (progress);
    return !interrupted();
  };
  const MultiframeEstimator estimator (options.energy, solver, options.multiframe);
  outcome.result = estimator.estimate (frames, reference, segments);
  outcome.seconds.total = total.lap();
  throwIfInterrupted();
  return outcome;
}

} // namespace pcl_msf::tool
