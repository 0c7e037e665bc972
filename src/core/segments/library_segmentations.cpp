// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/library_segmentations.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/segmentation.hpp>
#include <opencv2/ximgproc/slic.hpp>

#include "core/base/lazy_library.h"
#include "core/base/opencv_threads.h"

#include <algorithm>
#include <vector>

namespace pcl_msf {

namespace {

namespace ximgproc = cv::ximgproc;
using GraphSegmentation = ximgproc::segmentation::GraphSegmentation;

cv::Ptr<GraphSegmentation>
graphSegmentation (double smoothing, float threshold, int min_size)
{
#ifdef PCL_MSF_XIMGPROC_FILES
  static auto* const create =
      loadFunction<cv::Ptr<GraphSegmentation> (double, float, int)> (
          {PCL_MSF_XIMGPROC_FILES},
          "_ZN2cv8ximgproc12segmentation23createGraphSegmentationEdfi");
  return create (smoothing, threshold, min_size);
#else
  return ximgproc::segmentation::createGraphSegmentation (
      smoothing, threshold, min_size);
#endif
}

cv::Ptr<ximgproc::SuperpixelSLIC>
superpixels (const cv::Mat& image, int size, float smoothness)
{
#ifdef PCL_MSF_XIMGPROC_FILES
  static auto* const create = loadFunction<cv::Ptr<ximgproc::SuperpixelSLIC> (
      cv::InputArray, int, int, float)> (
      {PCL_MSF_XIMGPROC_FILES},
      "_ZN2cv8ximgproc20createSuperpixelSLICERKNS_11_InputArrayEiif");
  return create (image, ximgproc::SLIC, size, smoothness);
#else
  return ximgproc::createSuperpixelSLIC (image, ximgproc::SLIC, size, smoothness);
#endif
}

cv::Mat
depthWithHolesAtZero (const cv::Mat& inverse_depth)
{
  cv::Mat depth = cv::Mat::zeros (inverse_depth.size(), CV_32FC1);
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x)
      if (inverse_depth.at<float> (y, x) > 0.0f)
        depth.at<float> (y, x) = 1.0f / inverse_depth.at<float> (y, x);
  return depth;
}

/** Marks labels with fewer points with depth than wanted as -1. */
void
discardSmall (const cv::Mat& inverse_depth, int min_points, cv::Mat& labels)
{
  double largest = 0.0;
  cv::minMaxLoc (labels, nullptr, &largest);
  std::vector<int> sizes (static_cast<std::size_t> (largest) + 1, 0);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (inverse_depth.at<float> (y, x) > 0.0f)
        ++sizes[labels.at<int> (y, x)];
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (sizes[labels.at<int> (y, x)] < min_points)
        labels.at<int> (y, x) = -1;
}

} // namespace

cv::Mat
segmentByFelzenszwalb (const FrameLevel& level,
                       const SegmentationParameters& parameters,
                       int threads)
{
  constexpr double kSmoothing = 0.5; // Felzenszwalb's sigma, pixels
  // The library drops small components by merging them; keep them to discard them.
  const int min_size = parameters.discard_small ? 1 : parameters.min_points;
  const auto segmentation = graphSegmentation (
      kSmoothing, static_cast<float> (parameters.threshold), min_size);
  cv::Mat labels;
  withThreads (threads, [&] {
    segmentation->processImage (depthWithHolesAtZero (level.inverse_depth), labels);
  });
  if (parameters.discard_small)
    discardSmall (level.inverse_depth, parameters.min_points, labels);
  return labels;
}

cv::Mat
segmentBySlic (const FrameLevel& level, int size, int threads)
{
  cv::Mat features[2]; // both scaled to a Lab-like range
  if (level.intensity.empty())
    features[0] = cv::Mat::zeros (level.inverse_depth.size(), CV_32FC1);
  else
    level.intensity.convertTo (features[0], CV_32F, 100.0);
  double largest = 1.0;
  cv::minMaxLoc (level.inverse_depth, nullptr, &largest);
  level.inverse_depth.convertTo (features[1], CV_32F, 255.0 / largest);
  cv::Mat image;
  cv::merge (features, 2, image);
  cv::Mat labels;
  withThreads (threads, [&] {
    const auto slic = superpixels (image, size, 10.0f);
    slic->iterate (5);
    slic->enforceLabelConnectivity (25);
    slic->getLabels (labels);
  });
  return labels;
}

} // namespace pcl_msf
