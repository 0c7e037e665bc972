// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/layer_sum.h"

#include <algorithm>

namespace pcl_msf::visualization {

void
LayerSum::add (const cv::Mat& layer)
{
  CV_Assert (layer.type() == CV_8UC4);
  if (color_.empty()) {
    color_ = cv::Mat::zeros (layer.size(), CV_32FC3);
    coverage_ = cv::Mat::zeros (layer.size(), CV_32FC2);
  }
  for (int row = 0; row < layer.rows; ++row)
    for (int col = 0; col < layer.cols; ++col) {
      const auto& pixel = layer.at<cv::Vec4b> (row, col);
      const float alpha = static_cast<float> (pixel[3]) / 255.0F;
      auto& share = coverage_.at<cv::Vec2f> (row, col);
      share = {share[0] + alpha, std::max (share[1], alpha)};
      for (int c = 0; c < 3; ++c) // the picture is alpha color + (1 - alpha) background
        color_.at<cv::Vec3f> (row, col)[c] +=
            static_cast<float> (pixel[c]) - (1.0F - alpha) * background_[c];
    }
}

cv::Mat
LayerSum::mean() const
{
  cv::Mat picture (color_.size(), CV_8UC3, cv::Scalar (background_));
  for (int row = 0; row < color_.rows; ++row)
    for (int col = 0; col < color_.cols; ++col) {
      const auto& share = coverage_.at<cv::Vec2f> (row, col);
      if (!(share[0] > 0.0F))
        continue;
      for (int c = 0; c < 3; ++c)
        picture.at<cv::Vec3b> (row, col)[c] = cv::saturate_cast<unsigned char> (
            share[1] * color_.at<cv::Vec3f> (row, col)[c] / share[0] +
            (1.0F - share[1]) * background_[c]);
    }
  return picture;
}

} // namespace pcl_msf::visualization
