// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "view/stream_solver.h"

#include "common/default_estimation.h"
#include "core/base/number_text.h"

#include <exception>
#include <utility>

namespace pcl_msf::tool {

StreamSolver::StreamSolver (std::unique_ptr<FrameSource> source,
                            const PlayerSettings& settings,
                            Warn warn)
: source_ (std::move (source))
, settings_ (settings)
, warn_ (std::move (warn))
, title_ ("waiting for the second frame")
, queue_ (settings.queue)
, thread_ ([this] { run(); })
{}

StreamSolver::~StreamSolver()
{
  stop_ = true;
  queue_.close();
  thread_.join();
}

void
StreamSolver::run()
{
  try {
    play();
  }
  catch (const std::exception& e) {
    const std::lock_guard<std::mutex> lock (mutex_);
    problem_ = e.what();
  }
}

void
StreamSolver::play()
{
  StreamTracker tracker (settings_, [this] { return !stop_; });
  FramePlayer player (*source_, queue_);
  while (const auto frame = queue_.pop()) {
    if (stop_)
      return;
    take (*frame, tracker);
  }
  if (!stop_)
    player.requireFrames();
}

void
StreamSolver::take (const StreamFrame& frame, StreamTracker& tracker)
{
  const StreamResult result = tracker.take (frame);
  if (result.cancelled)
    return;
  if (!result.problem.empty()) {
    warn_ ("frame " + std::to_string (result.index) + ": lost: " + result.problem);
    return;
  }
  colors_[frame.index] = frame.images.color;
  colors_.erase (colors_.begin(), colors_.lower_bound (result.reference));
  if (!result.first)
    publish (frame, result, tracker.sceneFlow());
  if (settings_.window == 0 && colors_.size() > 2) // those between are not asked for
    colors_.erase (std::next (colors_.begin()), std::prev (colors_.end()));
}

void
StreamSolver::publish (const StreamFrame& frame,
                       const StreamResult& result,
                       const SceneFlow& flow)
{
  auto clouds = std::make_shared<visualization::ResultClouds>();
  clouds->scene_flow = flow;
  clouds->reference_color = colors_.begin()->second;
  takeCurrent (frame.images, *clouds);
  const std::string title = "frame " + std::to_string (result.index) + " since frame " +
                            std::to_string (result.reference) + ", " +
                            std::to_string (result.groups) + " motion groups, " +
                            fixedText (1e3 * result.latency, 0) + " ms, dropped " +
                            std::to_string (queue_.dropped() + source_->skipped());
  const std::lock_guard<std::mutex> lock (mutex_);
  newest_ = std::move (clouds);
  title_ = title;
  ++solved_;
}

int
StreamSolver::solved() const
{
  return solved_;
}

ResultSource::Result
StreamSolver::result (int number) const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return number == solved_ - 1 ? newest_ : nullptr;
}

std::string
StreamSolver::title (int /* number */) const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return title_;
}

std::string
StreamSolver::problem() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return problem_;
}

} // namespace pcl_msf::tool
