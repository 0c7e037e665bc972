// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/frame_tracker.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/scene_flow_tracker.h>

#include <memory>
#include <string>
#include <utility>

namespace pcl_msf {

SceneFlowTracker::SceneFlowTracker() : own_ (std::make_unique<FrameTracker>()) {}

SceneFlowTracker::SceneFlowTracker (const TrackerParameters& tracker,
                                    const SegmentationParameters& segmentation,
                                    const EnergyParameters& energy,
                                    const SolverParameters& solver,
                                    const MultiframeParameters& multiframe)
: own_ (std::make_unique<FrameTracker> (
      tracker, segmentation, energy, solver, multiframe))
{}

SceneFlowTracker::SceneFlowTracker (const SceneFlowTracker& other)
: own_ (std::make_unique<FrameTracker> (*other.own_))
{}

SceneFlowTracker&
SceneFlowTracker::operator= (const SceneFlowTracker& other)
{
  *own_ = *other.own_;
  return *this;
}

SceneFlowTracker::SceneFlowTracker (SceneFlowTracker&& other) : SceneFlowTracker()
{
  own_.swap (other.own_);
}

SceneFlowTracker&
SceneFlowTracker::operator= (SceneFlowTracker&& other)
{
  SceneFlowTracker taken (std::move (other)); // first: it may be this one
  own_.swap (taken.own_);
  return *this;
}

SceneFlowTracker::~SceneFlowTracker() = default;

void
SceneFlowTracker::add (const RgbdFrame& frame)
{
  own_->add (frame);
}

void
SceneFlowTracker::reset()
{
  own_->reset();
}

int
SceneFlowTracker::frames() const
{
  return own_->frames();
}

long
SceneFlowTracker::firstFrame() const
{
  return own_->indices().empty() ? 0 : own_->indices().front();
}

long
SceneFlowTracker::frameIndex (int frame) const
{
  const std::vector<long>& indices = own_->indices();
  if (frame < 0 || static_cast<std::size_t> (frame) >= indices.size())
    throw InvalidInput ("frameIndex: there is no frame " + std::to_string (frame) +
                        " in a window of " + std::to_string (indices.size()) +
                        ": give 0 to frames() - 1");
  return indices[frame];
}

const MultiframeSceneFlow&
SceneFlowTracker::result() const
{
  return own_->result();
}

const SceneFlow&
SceneFlowTracker::sceneFlow() const
{
  return own_->sceneFlow();
}

const Oversegmentation&
SceneFlowTracker::segments() const
{
  return own_->segments();
}

RigidPose
SceneFlowTracker::cameraPose() const
{
  return own_->cameraPose();
}

} // namespace pcl_msf
