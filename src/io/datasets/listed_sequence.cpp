// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/listed_sequence.h"

#include "io/datasets/frame_parts.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>

#include <utility>

namespace pcl_msf::io {

ListedSequence::ListedSequence (std::string name,
                                std::vector<FrameFiles> files,
                                double depth_scale,
                                const cv::Size& size,
                                double float_scale)
: name_ (std::move (name))
, files_ (std::move (files))
, depth_scale_ (depth_scale)
, size_ (size)
, float_scale_ (float_scale)
{}

std::string
ListedSequence::name() const
{
  return name_;
}

int
ListedSequence::frames() const
{
  return static_cast<int> (files_.size());
}

RgbdImages
ListedSequence::frame (int k) const
{
  const FrameFiles& f = files (k);
  const cv::Mat metres = depth (f);
  requireSize (f.depth, metres, size_);
  return makeFrame (f.color, f.depth, metres, f.camera, f.distortion);
}

double
ListedSequence::timestamp (int k) const
{
  return files (k).timestamp;
}

std::optional<RigidPose>
ListedSequence::cameraPose (int k) const
{
  return files (k).world_from_camera;
}

cv::Mat
ListedSequence::depth (const FrameFiles& files) const
{
  return readDepth (files.depth, depth_scale_, float_scale_);
}

const FrameFiles&
ListedSequence::files (int k) const
{
  if (k < 0 || k >= frames())
    throw InvalidInput (noSuchFrame (name_, k, frames()));
  return files_[static_cast<std::size_t> (k)];
}

bool
ListedSequence::follows (int from, int to) const
{
  return files (to).number == files (from).number + 1;
}

cv::Size
ListedSequence::imageSize (int k) const
{
  const FrameFiles& f = files (k);
  return f.color.empty() ? depth (f).size() : readColor (f.color).size();
}

} // namespace pcl_msf::io
