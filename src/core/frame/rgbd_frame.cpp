// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/tuning/tuning.h"
#include "core/frame/depth_pyramid.h"
#include "core/frame/depth_range.h"
#include "core/frame/frame_size.h"
#include "core/frame/noise.h"
#include "core/frame/normals.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/rgbd_frame.h>

#include <algorithm>
#include <limits>
#include <string>

namespace pcl_msf {

namespace {

void
requireUsable (const cv::Mat& color,
               const cv::Mat& depth,
               const PinholeCamera& camera,
               const FrameParameters& parameters,
               const cv::Mat& normals)
{
  std::string why;
  if (!parameters.isValid (&why))
    throw InvalidInput ("frame parameters: " + why);
  if (depth.empty() || depth.type() != CV_32FC1)
    throw InvalidInput ("depth must be a non-empty CV_32FC1 image in metres");
  why = whyTooSmall (depth.size());
  if (!why.empty())
    throw InvalidInput ("the frame " + why);
  if (!color.empty() && color.size() != depth.size())
    throw InvalidInput ("the colour is " + sizeText (color.size()) + ", the depth " +
                        sizeText (depth.size()) + "; register them to each other");
  if (!color.empty() && color.type() != CV_8UC1 && color.type() != CV_8UC3 &&
      color.type() != CV_32FC1)
    throw InvalidInput ("colour must be CV_8UC1, CV_8UC3 (BGR) or CV_32FC1");
  if (!normals.empty() &&
      (normals.size() != depth.size() || normals.type() != CV_32FC3))
    throw InvalidInput ("normals must be CV_32FC3 of the size of the depth image");
  if (!camera.isValid (depth.cols, depth.rows, &why))
    throw InvalidInput (why);
  if (!hasDepth (depth, parameters, &why))
    throw InvalidInput ("no valid depth: " + why);
  const int finest = parameters.finest_level;
  why = whyTooSmall ({depth.cols >> finest, depth.rows >> finest});
  if (!why.empty())
    throw InvalidInput ("finest_level is " + std::to_string (finest) +
                        ", at which the frame of " + sizeText (depth.size()) + " " +
                        why + "; use a lower one");
}

/** Grey in [0, 1]; NaN in a float image counts as black. */
cv::Mat
toIntensity (const cv::Mat& color)
{
  cv::Mat intensity;
  if (color.type() == CV_32FC1) {
    intensity = color;
    if (intensityUnit ({&intensity}) > 1.0)
      throw InvalidInput (
          "colour as CV_32FC1 must be in [0, 1]; bring all frames there "
          "together, by normalizeIntensity");
    normalizeIntensity ({&intensity}, 1.0);
    return intensity;
  }
  cv::Mat gray = color;
  if (color.channels() == 3)
    inThisThread ([&] { cv::cvtColor (color, gray, cv::COLOR_BGR2GRAY); });
  gray.convertTo (intensity, CV_32F, 1.0 / 255.0);
  return intensity;
}

cv::Mat
unitOrZero (const cv::Mat& normals)
{
  cv::Mat result = cv::Mat::zeros (normals.size(), CV_32FC3);
  for (int y = 0; y < normals.rows; ++y)
    for (int x = 0; x < normals.cols; ++x) {
      const cv::Vec3f n = normals.at<cv::Vec3f> (y, x);
      const double length = cv::norm (n);
      if (length > 1e-6 && length < 1e6)
        result.at<cv::Vec3f> (y, x) = n * static_cast<float> (1.0 / length);
    }
  return result;
}

FrameLevel
halve (const FrameLevel& fine, double noise, const FrameTuning& tuning)
{
  FrameLevel coarse;
  coarse.camera = fine.camera.halved();
  if (!fine.intensity.empty())
    inThisThread ([&] { cv::pyrDown (fine.intensity, coarse.intensity); });
  coarse.inverse_depth = halveInverseDepth (fine.inverse_depth, noise, tuning);
  if (!fine.normals.empty())
    coarse.normals = halveNormals (fine.normals);
  return coarse;
}

cv::Mat
normalsOf (const FrameLevel& level,
           double noise,
           NormalMethod method,
           const NormalTuning& tuning)
{
  switch (method) {
  case NormalMethod::IntegralImage:
    return normalsByIntegralImage (level.inverse_depth, level.camera);
  case NormalMethod::Skip:
    return cv::Mat::zeros (level.inverse_depth.size(), CV_32FC3);
  case NormalMethod::CentralDifferences:
    break;
  }
  return normalsByCentralDifferences (level.inverse_depth, level.camera, noise, tuning);
}

} // namespace

RgbdFrame
RgbdFrame::fromImages (const cv::Mat& color,
                       const cv::Mat& depth,
                       const PinholeCamera& camera,
                       const FrameParameters& parameters,
                       const cv::Mat& normals)
{
  requireUsable (color, depth, camera, parameters, normals);
  const FrameTuning tuning = currentTuning().frame;
  RgbdFrame frame;
  FrameLevel level;
  level.camera = camera;
  level.inverse_depth =
      inverseDepth (depth, parameters.min_depth, parameters.max_depth);
  const double noise = frame.inverse_depth_noise_ =
      estimateInverseDepthNoise (level.inverse_depth);
  if (!color.empty()) {
    level.intensity = toIntensity (color);
    frame.intensity_noise_ = estimateIntensityNoise (level.intensity);
    if (color.type() == CV_8UC3)
      frame.color_ = color.clone();
  }
  if (!normals.empty())
    level.normals = unitOrZero (normals);
  if (parameters.finest_level > 0) {
    frame.finest_level_ = parameters.finest_level;
    frame.input_camera_ = camera;
    frame.input_inverse_depth_ = level.inverse_depth;
  }
  for (int i = 0; i < parameters.finest_level; ++i)
    level = halve (level, noise, tuning);
  if (!color.empty()) {
    level.intensity.convertTo (frame.gray_, CV_8U, 255.0);
    if (parameters.smoothing_sigma > 0.0)
      inThisThread ([&] {
        cv::GaussianBlur (
            level.intensity, level.intensity, {}, parameters.smoothing_sigma);
      });
  }
  if (level.normals.empty())
    level.normals = normalsOf (level, noise, parameters.normals, tuning.normals);
  frame.levels_.push_back (level);
  while (static_cast<int> (frame.levels_.size()) < parameters.max_levels &&
         std::min (level.width(), level.height()) >= 2 * tuning.smallest_side) {
    level = halve (level, noise, tuning);
    frame.levels_.push_back (level);
  }
  return frame;
}

} // namespace pcl_msf
