// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/frame_maker.h"

#include "common/depth_check.h"

#include <exception>
#include <utility>

namespace pcl_msf::tool {

namespace {

constexpr int kLargeFrame = 480; // columns: of fewer a tracker keeps up with a camera

} // namespace

FrameMaker::FrameMaker (const PlayerSettings& settings,
                        std::string name,
                        bool defines_depth_unit,
                        Warn warn)
: settings_ (settings)
, name_ (std::move (name))
, defines_depth_unit_ (defines_depth_unit)
, warn_ (std::move (warn))
{}

void
FrameMaker::warnOnce (const std::string& kind, const std::string& text)
{
  if (warned_.insert (kind).second)
    warn_ (text);
}

void
FrameMaker::take (StreamFrame& frame, io::RgbdImages images)
{
  const std::string name = name_ + ": frame " + std::to_string (frame.index);
  if (!images.note.empty())
    warnOnce ("colour", name + ": " + images.note);
  const std::string problem =
      checkDepth (images.depth,
                  settings_.frame,
                  name,
                  {settings_.reading.depth_scale, defines_depth_unit_});
  if (!problem.empty())
    warnOnce ("depth", problem);
  if (!color_unit_)
    color_unit_ = io::colorUnit ({&images});
  io::setColorUnit (images, *color_unit_);
  FrameParameters parameters = settings_.frame;
  if (settings_.halve_large && images.depth.cols >= kLargeFrame)
    parameters.finest_level = 1;
  frame.frame =
      RgbdFrame::fromImages (images.color, images.depth, images.camera, parameters);
  frame.images = std::move (images);
}

void
FrameMaker::make (StreamFrame& frame, const std::function<io::RgbdImages()>& load)
{
  try {
    take (frame, load());
    started_ = true;
  }
  catch (const std::exception& e) {
    if (!started_)
      throw;
    frame.problem = e.what();
  }
}

} // namespace pcl_msf::tool
