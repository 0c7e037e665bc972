// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "stream/frame_reader.h"

#include "common/depth_check.h"

#include <cmath>
#include <exception>
#include <utility>

namespace pcl_msf::tool {

FrameReader::FrameReader (const io::RgbdSequence& sequence,
                          const StreamOptions& options,
                          Warn warn)
: sequence_ (sequence), options_ (options), warn_ (std::move (warn))
{}

void
FrameReader::warnOnce (const std::string& kind, const std::string& text)
{
  if (warned_.insert (kind).second)
    warn_ (text);
}

RgbdFrame
FrameReader::load (int index)
{
  io::RgbdImages images = sequence_.frame (index);
  const std::string name = options_.source + ": frame " + std::to_string (index);
  if (!images.note.empty())
    warnOnce ("colour", name + ": " + images.note);
  const std::string problem =
      checkDepth (images.depth,
                  options_.frame,
                  name,
                  {options_.reading.depth_scale, sequence_.definesDepthUnit()});
  if (!problem.empty())
    warnOnce ("depth", problem);
  if (!color_unit_)
    color_unit_ = io::colorUnit ({&images});
  io::setColorUnit (images, *color_unit_);
  return RgbdFrame::fromImages (
      images.color, images.depth, images.camera, options_.frame);
}

StreamFrame
FrameReader::read (int index)
{
  StreamFrame result;
  result.index = index;
  const double seconds = sequence_.timestamp (index);
  result.seconds = std::isfinite (seconds) ? seconds : index;
  try {
    result.frame = load (index);
    started_ = true;
  }
  catch (const std::exception& e) {
    if (!started_)
      throw;
    result.problem = e.what();
  }
  result.arrival = StreamClock::now();
  return result;
}

} // namespace pcl_msf::tool
