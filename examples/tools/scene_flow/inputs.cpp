// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "inputs.h"

#include "common/depth_check.h"
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/undistortion.h>

#include <cmath>
#include <future>
#include <utility>

namespace pcl_msf::tool {

namespace {

constexpr double kDefaultDepthScale = 1000.0;
constexpr int kDefaultWindow = 4; // frames of a recording

std::shared_ptr<const io::RgbdSequence>
openSequence (const Options& options)
{
  io::DatasetOptions dataset;
  dataset.camera = options.camera;
  dataset.distortion = options.distortion;
  dataset.depth_scale = options.depth_scale;
  dataset.max_time_difference = options.max_time_difference;
  const auto sequences =
      io::openDataset (io::DatasetKind::Automatic, options.sequence, dataset);
  if (sequences.size() != 1)
    throw UsageError ("'" + options.sequence + "': holds " +
                      std::to_string (sequences.size()) + " sequences, " +
                      sequences.front()->name() + ", " + sequences.at (1)->name() +
                      ", ...; give one of their folders");
  return sequences.front();
}

void
checkSize (const char* option,
           const std::string& path,
           const cv::Mat& image,
           const cv::Size& size)
{
  if (!image.empty() && image.size() != size)
    throw UsageError (std::string (option) + ": " + path + " is " +
                      std::to_string (image.cols) + "x" + std::to_string (image.rows) +
                      ", the reference's depth " + std::to_string (size.width) + "x" +
                      std::to_string (size.height) + "; all images must have one size");
}

} // namespace

Inputs::Inputs (const Options& options, Warn warn)
: options_ (options), warn_ (std::move (warn))
{
  if (!options.sequence.empty())
    sequence_ = openSequence (options);
  if (frames() < 2)
    throw UsageError ("'" + options.sequence + "': holds one frame; two are needed");
  const int standard = sequence_ ? std::min (frames(), kDefaultWindow) : frames();
  window_ = options.window > 0 ? std::min (options.window, frames()) : standard;
  if (options.window > frames())
    warn_ ("--window: " + std::to_string (options.window) + ", but there are " +
           std::to_string (frames()) + " frames; the window is all of them");
  if (options.reference >= window_)
    throw UsageError ("--reference: " + std::to_string (options.reference) +
                      ", must be less than the window's " + std::to_string (window_) +
                      " frames");
}

int
Inputs::frames() const
{
  if (sequence_)
    return sequence_->frames();
  return static_cast<int> (options_.cloud.empty() ? options_.depth.size()
                                                  : options_.cloud.size());
}

double
Inputs::timestamp (int frame) const
{
  const double seconds = sequence_ ? sequence_->timestamp (frame) : std::nan ("");
  return std::isfinite (seconds) ? seconds : frame;
}

io::RgbdImages
Inputs::loadFrame (int frame) const
{
  if (sequence_)
    return sequence_->frame (frame);
  if (!options_.cloud.empty())
    return io::readCloudImages (
        options_.cloud[frame], options_.camera, options_.depth_scale.value_or (1.0));
  io::RgbdImages images;
  images.camera = *options_.camera;
  images.depth = io::readDepth (options_.depth[frame],
                                options_.depth_scale.value_or (kDefaultDepthScale),
                                options_.depth_scale.value_or (1.0));
  if (!options_.color.empty())
    io::readColor (options_.color[frame], images);
  if (options_.distortion)
    io::undistort (images, *options_.distortion);
  return images;
}

std::string
Inputs::nameOf (int frame) const
{
  if (sequence_)
    return options_.sequence + ": frame " + std::to_string (frame);
  return options_.cloud.empty() ? options_.depth[frame] : options_.cloud[frame];
}

void
Inputs::warnOnce (const std::string& kind, const std::string& text)
{
  if (warned_.insert (kind).second)
    warn_ (text);
}

void
Inputs::checkSizes (int first, const std::vector<io::RgbdImages>& images) const
{
  const cv::Size size = images.front().depth.size();
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::size_t frame = first + i;
    if (sequence_) {
      checkSize ("frame", std::to_string (frame), images[i].depth, size);
      checkSize ("frame", std::to_string (frame), images[i].color, size);
    }
    else if (!options_.cloud.empty())
      checkSize ("--cloud", options_.cloud[frame], images[i].depth, size);
    else {
      checkSize ("--depth", options_.depth[frame], images[i].depth, size);
      if (!options_.color.empty())
        checkSize ("--color", options_.color[frame], images[i].color, size);
    }
    std::string why;
    if (!images[i].camera.isValid (size.width, size.height, &why))
      throw UsageError ("--camera: " + why);
  }
}

void
Inputs::checkContent (int first, const std::vector<io::RgbdImages>& images)
{
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string name = nameOf (first + static_cast<int> (i));
    if (!images[i].note.empty())
      warnOnce ("colour", name + ": " + images[i].note);
    const DepthUnit unit{options_.depth_scale,
                         sequence_ && sequence_->definesDepthUnit()};
    const std::string problem =
        checkDepth (images[i].depth, options_.frame, name, unit);
    if (!problem.empty())
      warnOnce ("depth", problem);
  }
}

void
Inputs::unifyColors (int first, std::vector<io::RgbdImages>& images)
{
  bool all = true;
  for (const io::RgbdImages& image : images)
    all &= !image.color.empty();
  for (std::size_t i = 0; i < images.size(); ++i)
    if (!all && !images[i].color.empty()) {
      warnOnce ("colour",
                nameOf (first + static_cast<int> (i)) +
                    ": its colour is not used, for other frames have none: geometry "
                    "alone");
      images[i].color.release();
      images[i].raw_color.release();
    }
  std::vector<const io::RgbdImages*> frames;
  for (const io::RgbdImages& image : images)
    frames.push_back (&image);
  const double unit = color_unit_.value_or (io::colorUnit (frames));
  for (io::RgbdImages& image : images)
    io::setColorUnit (image, unit);
  if (options_.track)
    color_unit_ = unit;
}

std::vector<io::RgbdImages>
Inputs::load (int first, int count)
{
  const auto policy =
      options_.solver.threads == 1 ? std::launch::deferred : std::launch::async;
  std::vector<std::future<io::RgbdImages>> later;
  for (int i = 1; i < count; ++i)
    later.push_back (std::async (policy, [=] { return loadFrame (first + i); }));
  std::vector<io::RgbdImages> images{loadFrame (first)};
  for (auto& image : later)
    images.push_back (image.get());
  checkSizes (first, images);
  checkContent (first, images);
  unifyColors (first, images);
  return images;
}

cv::Mat
Inputs::labels (const cv::Size& size) const
{
  if (options_.labels.empty())
    return {};
  const cv::Mat labels = io::readLabels (options_.labels);
  checkSize ("--labels", options_.labels, labels, size);
  return labels;
}

} // namespace pcl_msf::tool
