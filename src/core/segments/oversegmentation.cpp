// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include "core/base/tuning/tuning.h"
#include "core/segments/connected_segments.h"
#include "core/segments/library_segmentations.h"
#include "core/segments/segment_pixels.h"
#include "core/segments/surface_clusters.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/oversegmentation.h>

#include <algorithm>

namespace pcl_msf {

namespace {

/** Renumbers the labels of pixels with depth to 0 .. n - 1 in ascending order. */
int
makeDense (const cv::Mat& inverse_depth, cv::Mat& labels)
{
  std::vector<int> used;
  int last = -1;
  for (int y = 0; y < labels.rows; ++y) {
    int* row = labels.ptr<int> (y);
    const float* w = inverse_depth.ptr<float> (y);
    for (int x = 0; x < labels.cols; ++x)
      if (row[x] < 0 || w[x] <= 0.0f)
        row[x] = -1;
      else if (row[x] != last)
        used.push_back (last = row[x]);
  }
  std::sort (used.begin(), used.end());
  used.erase (std::unique (used.begin(), used.end()), used.end());
  last = -1;
  int number = -1;
  for (int y = 0; y < labels.rows; ++y) {
    int* row = labels.ptr<int> (y);
    for (int x = 0; x < labels.cols; ++x) {
      if (row[x] < 0)
        continue;
      if (row[x] != last) {
        last = row[x];
        number = static_cast<int> (std::lower_bound (used.begin(), used.end(), last) -
                                   used.begin());
      }
      row[x] = number;
    }
  }
  return static_cast<int> (used.size());
}

cv::Mat
tileLabels (const FrameLevel& level, int size)
{
  const int columns = (level.width() + size - 1) / size;
  cv::Mat labels (level.height(), level.width(), CV_32SC1);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      labels.at<int> (y, x) = (y / size) * columns + x / size;
  return labels;
}

cv::Mat
cut (const RgbdFrame& frame, const SegmentationParameters& parameters, int threads)
{
  const FrameLevel& level = frame.levels()[0];
  const int size = parameters.segment_size;
  switch (parameters.method) {
  case SegmentationMethod::Felzenszwalb:
    return segmentByFelzenszwalb (level, parameters, threads);
  case SegmentationMethod::Slic:
    return segmentBySlic (level, size, threads);
  case SegmentationMethod::Tiles:
    return tileLabels (level, size);
  case SegmentationMethod::Single:
    return cv::Mat::zeros (level.height(), level.width(), CV_32SC1);
  case SegmentationMethod::TangentPlane:
    break;
  }
  const SegmentTuning tuning = currentTuning().segments;
  const double noise = frame.inverseDepthNoise();
  const int min_points = std::max (8, size * size / 8);
  return connectSegments (clusterSurfaces (level, noise, size, tuning, threads),
                          level,
                          noise,
                          min_points,
                          tuning,
                          threads);
}

} // namespace

Oversegmentation
Oversegmentation::fromFrame (const RgbdFrame& frame,
                             const SegmentationParameters& parameters,
                             unsigned threads)
{
  std::string why;
  if (!parameters.isValid (&why))
    throw InvalidInput ("segmentation parameters: " + why);
  if (frame.empty())
    throw InvalidInput ("segmentation: the frame is empty");
  return fromLabels (cut (frame, parameters, threadCount (threads)), frame);
}

Oversegmentation
Oversegmentation::fromLabels (const cv::Mat& labels, const RgbdFrame& frame)
{
  if (frame.empty())
    throw InvalidInput ("segmentation: the frame is empty");
  const bool of_input = labels.size() == frame.inputInverseDepth().size();
  const cv::Size size (frame.width(), frame.height());
  if (labels.type() != CV_32SC1 || (!of_input && labels.size() != size))
    throw InvalidInput ("labels must be a CV_32SC1 image of the frame's size");
  Oversegmentation result;
  result.labels_ = labels.clone();
  for (int i = 0; of_input && i < frame.finestLevel(); ++i)
    result.labels_ = halveLabels (result.labels_);
  result.size_ = makeDense (frame.levels()[0].inverse_depth, result.labels_);
  if (result.size_ == 0)
    throw InvalidInput ("no segment has a point with depth: give labels or indices of "
                        "points that were measured");
  return result;
}

Oversegmentation
Oversegmentation::fromIndices (const std::vector<pcl::PointIndices>& clusters,
                               const RgbdFrame& frame)
{
  if (frame.empty())
    throw InvalidInput ("segmentation: the frame is empty");
  cv::Mat labels (frame.inputInverseDepth().size(), CV_32SC1, cv::Scalar (-1));
  const int pixels = static_cast<int> (labels.total());
  for (std::size_t k = 0; k < clusters.size(); ++k)
    for (const int index : clusters[k].indices) {
      if (index < 0 || index >= pixels)
        throw InvalidInput ("cluster " + std::to_string (k) + " has index " +
                            std::to_string (index) + ", the cloud only " +
                            std::to_string (labels.cols) + "x" +
                            std::to_string (labels.rows) +
                            " points: give setSegmentation the source's own clusters");
      int& label = labels.at<int> (index / labels.cols, index % labels.cols);
      if (label < 0)
        label = static_cast<int> (k);
    }
  return fromLabels (labels, frame);
}

} // namespace pcl_msf
