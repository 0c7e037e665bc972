// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "tracking.h"

#include "common/interruption.h"
#include "common/progress_line.h"
#include "common/stop_watch.h"
#include <pcl_msf/errors.h>

#include <string>
#include <utility>

namespace pcl_msf::tool {

namespace {

TrackerParameters
trackerParameters (const Inputs& inputs)
{
  TrackerParameters parameters;
  parameters.window = inputs.window();
  return parameters;
}

SolverParameters
interruptible (SolverParameters solver)
{
  solver.progress = [] (const Progress&) { return !interrupted(); };
  return solver;
}

} // namespace

Tracking::Tracking (const Options& options, Inputs& inputs)
: options_ (options)
, inputs_ (inputs)
, tracker_ (trackerParameters (inputs),
            options.segmentation,
            options.energy,
            interruptible (options.solver),
            options.multiframe)
, reference_{0, {}}
, newest_{0, {}}
{
  limitThreads (options);
}

Outcome
Tracking::next()
{
  ProgressLine line (!options_.quiet);
  Outcome outcome;
  StopWatch total, watch;
  line.stage ("load");
  Taken taken{frame_, inputs_.load (frame_, 1).front()};
  outcome.seconds.load = watch.lap();
  line.stage ("frames");
  try {
    const RgbdFrame frame = RgbdFrame::fromImages (
        taken.images.color, taken.images.depth, taken.images.camera, options_.frame);
    outcome.seconds.frame = watch.lap();
    throwIfInterrupted();
    line.stage ("track");
    tracker_.add (frame);
  }
  catch (const InvalidInput& e) {
    throw InvalidInput ("frame " + std::to_string (frame_) + ": " + e.what());
  }
  throwIfInterrupted();
  if (frame_ == 0)
    reference_ = taken;
  else if (tracker_.firstFrame() != reference_.index)
    reference_ = std::move (newest_);
  newest_ = std::move (taken);
  ++frame_;
  outcome.result = tracker_.result();
  const int count = static_cast<int> (outcome.result.frames.size());
  for (int k = 0; k < count; ++k)
    outcome.indices.push_back (static_cast<int> (tracker_.frameIndex (k)));
  outcome.images.resize (count);
  if (count > 0) {
    outcome.images.front() = reference_.images;
    outcome.images.back() = newest_.images;
    outcome.first_new = count - 1;
  }
  outcome.seconds.total = total.lap();
  return outcome;
}

} // namespace pcl_msf::tool
