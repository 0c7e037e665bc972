// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "inputs.h"

#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/images.h>

#include <future>

namespace pcl_msf::tool {

namespace {

constexpr double kDefaultDepthScale = 1000.0;

io::RgbdImages
loadFrame (const Options& options, std::size_t frame)
{
  if (!options.cloud.empty())
    return io::readCloudImages (options.cloud[frame], options.camera);
  io::RgbdImages images;
  images.camera = *options.camera;
  images.depth = io::readDepth (options.depth[frame],
                                options.depth_scale.value_or (kDefaultDepthScale));
  if (!options.color.empty())
    images.color = io::readColor (options.color[frame]);
  return images;
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

void
checkSizes (const Options& options, const Inputs& inputs)
{
  const cv::Size size = inputs.reference.depth.size();
  if (options.cloud.empty()) {
    checkSize ("--depth", options.depth[1], inputs.current.depth, size);
    for (std::size_t i = 0; i < options.color.size(); ++i)
      checkSize ("--color",
                 options.color[i],
                 i == 0 ? inputs.reference.color : inputs.current.color,
                 size);
  }
  else
    checkSize ("--cloud", options.cloud[1], inputs.current.depth, size);
  checkSize ("--labels", options.labels, inputs.labels, size);
  std::string why;
  if (!inputs.reference.camera.isValid (size.width, size.height, &why))
    throw UsageError ("--camera: " + why);
}

} // namespace

Inputs
loadInputs (const Options& options)
{
  Inputs inputs;
  auto current =
      std::async (std::launch::async, [&options] { return loadFrame (options, 1); });
  inputs.reference = loadFrame (options, 0);
  inputs.current = current.get();
  if (inputs.reference.color.empty() || inputs.current.color.empty()) {
    inputs.reference.color.release();
    inputs.current.color.release();
  }
  if (!options.labels.empty())
    inputs.labels = io::readLabels (options.labels);
  checkSizes (options, inputs);
  return inputs;
}

} // namespace pcl_msf::tool
