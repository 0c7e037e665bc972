// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/depth_range.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

constexpr double kBeyondCameras =
    100.0;                          // metres; a limit there is no choice of a scene
constexpr double kFewBeyond = 0.01; // stray points
constexpr double kNearlyAll = 0.75;

struct DepthRange {
  float least{std::numeric_limits<float>::infinity()};
  float most{-std::numeric_limits<float>::infinity()};
  std::size_t finite{0};
  std::size_t positive{0};
  std::size_t near{0}; ///< positive, nearer than the limit
  std::size_t far{0};
};

/** Of the positive depths; of all finite ones when there are none. */
DepthRange
rangeOf (const cv::Mat& depth, const FrameParameters& limits)
{
  DepthRange all;
  DepthRange ahead;
  const auto take = [] (DepthRange& range, float z) {
    range.least = std::min (range.least, z);
    range.most = std::max (range.most, z);
  };
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const float z = depth.at<float> (v, u);
      if (!std::isfinite (z))
        continue;
      ++all.finite;
      take (all, z);
      if (z <= 0.0f)
        continue;
      take (ahead, z);
      ++ahead.positive;
      ahead.near += z < limits.min_depth;
      ahead.far += z > limits.max_depth;
    }
  ahead.finite = all.finite;
  return ahead.positive > 0 ? ahead : all;
}

std::string
limitsText (const FrameParameters& limits)
{
  PlainStream text;
  text << "FrameParameters' min_depth " << limits.min_depth << " to max_depth "
       << limits.max_depth << " m";
  return text.str();
}

std::string
remedy (const DepthRange& range, const FrameParameters& limits)
{
  if (range.far > 0 && limits.max_depth >= kBeyondCameras)
    return ": millimetres? give metres";
  return ": check the unit (metres) and the limits";
}

} // namespace

bool
hasDepth (const cv::Mat& depth, const FrameParameters& parameters, std::string* why)
{
  const DepthRange range = rangeOf (depth, parameters);
  if (range.positive > range.near + range.far)
    return true;
  PlainStream text;
  if (range.finite == 0)
    text << "it is not a number everywhere";
  else if (range.positive == 0 && range.most == 0.0f && range.least == 0.0f)
    text << "it is 0 everywhere";
  else if (range.positive == 0)
    text << "it is " << range.least << " to " << range.most << ", behind the camera";
  else
    text << "it is " << range.least << " to " << range.most << ", outside "
         << limitsText (parameters) << remedy (range, parameters);
  if (why)
    *why = text.str();
  return false;
}

std::string
droppedDepth (const cv::Mat& depth, const FrameParameters& parameters)
{
  const DepthRange range = rangeOf (depth, parameters);
  const double all = std::max<std::size_t> (range.positive, 1);
  const bool absurd =
      parameters.max_depth >= kBeyondCameras && range.far > kFewBeyond * all;
  const double share = (range.near + range.far) / all;
  if (!absurd && share <= kNearlyAll)
    return {};
  PlainStream text;
  text.precision (3);
  text << 100.0 * share << " % of the depth is not used: it is ";
  text.precision (6);
  text << range.least << " to " << range.most << ", beyond " << limitsText (parameters)
       << remedy (range, parameters);
  return text.str();
}

} // namespace pcl_msf
