// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/drawing.h"
#include "io/base/label_colors.h"
#include "io/base/motion_ranks.h"
#include <pcl_msf/io/figures.h>

#include <functional>

namespace pcl_msf::io {

namespace {

constexpr double kOpacity = 0.55;

cv::Vec3b
blend (const cv::Vec3b& under, const cv::Vec3b& over)
{
  cv::Vec3b result;
  for (int c = 0; c < 3; ++c)
    result[c] = cv::saturate_cast<unsigned char> ((1.0 - kOpacity) * under[c] +
                                                  kOpacity * over[c]);
  return result;
}

cv::Mat
overlay (const cv::Mat& image,
         const cv::Mat& labels,
         const std::function<cv::Vec3b (int)>& color)
{
  CV_Assert (labels.type() == CV_32SC1);
  cv::Mat picture = asBgr (image, labels.size());
  CV_Assert (picture.size() == labels.size());
  for (int row = 0; row < labels.rows; ++row)
    for (int col = 0; col < labels.cols; ++col) {
      const int label = labels.at<int> (row, col);
      auto& pixel = picture.at<cv::Vec3b> (row, col);
      if (label >= 0)
        pixel = blend (pixel, color (label));
      if (onBoundary (labels, row, col))
        pixel = {pixel * 0.3};
    }
  return picture;
}

} // namespace

cv::Mat
segmentOverlay (const cv::Mat& image, const cv::Mat& labels)
{
  return overlay (image, labels, labelColor);
}

cv::Mat
motionOverlay (const cv::Mat& image, const SceneFlow& scene_flow)
{
  const MotionRanks ranks (scene_flow);
  const int undetermined = ranks.undetermined();
  const cv::Mat groups = ranks.image (scene_flow.labels);
  // Colours stand out on grey only.
  const cv::Mat gray = image.empty() ? image : asGray (image);
  return overlay (gray, groups, [undetermined] (int group) -> cv::Vec3b {
    if (group == undetermined)
      return {0, 0, 0};
    return group == 0 ? cv::Vec3b (200, 200, 200) : labelColor (group - 1);
  });
}

} // namespace pcl_msf::io
