// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/depth_check.h"

#include "common/command_line.h"
#include "core/base/number_text.h"
#include "core/base/order_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf::tool {

namespace {

constexpr double kNearest = 1e-6;      // metres, of a frame
constexpr double kUnlikelyNear = 0.01; // metres, of the median
constexpr double kUnlikelyFar = 100.0; // metres, of the median
constexpr double kMuchDropped = 0.25;  // of what was measured

std::vector<float>
measuredDepth (const cv::Mat& depth)
{
  std::vector<float> measured;
  for (int row = 0; row < depth.rows; ++row)
    for (int col = 0; col < depth.cols; ++col) {
      const float z = depth.at<float> (row, col);
      if (std::isfinite (z) && z > 0.0F)
        measured.push_back (z);
    }
  return measured;
}

/** Whole metres without an exponent, as far as people read them. */
std::string
metresText (double metres)
{
  return metres >= 1000.0 && metres < 1e9 ? fixedText (metres, 0)
                                          : generalText (metres, 4);
}

/** Names a usual scale that would bring the median to where RGB-D cameras measure.
 * Without a given one floats had 1 and integers mostly 1000. */
std::string
remedy (double median, const DepthUnit& unit)
{
  const auto isUsual = [] (double metres) { return metres > 0.2 && metres < 20.0; };
  if (!unit.optional)
    return std::string ("give metres") +
           (isUsual (median / 1000.0) ? " (millimetres?)" : "");
  if (unit.defined)
    return "give other limits";
  const std::string give =
      unit.scale ? "give units per metre" : "give --depth-scale, units per metre";
  for (const double used : {unit.scale.value_or (1.0), unit.scale.value_or (1000.0)})
    for (const double usual : {1000.0, 1.0, 5000.0, 10000.0, 100.0}) {
      const double metres = median * used / usual;
      if (usual != used && isUsual (metres))
        return give + ", for example " + generalText (usual) +
               (usual == 1000.0 * used ? " (millimetres?)" : "");
    }
  return give + ", or other limits";
}

std::string
limitsText (const FrameParameters& limits, bool options)
{
  const std::string near = generalText (limits.min_depth);
  const std::string far = generalText (limits.max_depth);
  return options ? "--min-depth " + near + " and --max-depth " + far
                 : near + " and " + far + " m";
}

/** Whoever sets a limit wants points to be dropped. */
bool
areDefaults (const FrameParameters& limits)
{
  const FrameParameters standard;
  return limits.min_depth == standard.min_depth &&
         limits.max_depth == standard.max_depth;
}

} // namespace

std::string
checkDepth (const cv::Mat& depth,
            const FrameParameters& limits,
            const std::string& name,
            const DepthUnit& unit)
{
  std::vector<float> measured = measuredDepth (depth);
  if (measured.empty())
    throw UsageError (name + ": depth: no pixel has one; give another image");
  const double middle = median (measured);
  const auto kept = std::count_if (measured.begin(), measured.end(), [&] (float z) {
    return z >= std::max (limits.min_depth, kNearest) && z <= limits.max_depth;
  });
  const double dropped =
      1.0 - static_cast<double> (kept) / static_cast<double> (measured.size());
  const bool unlikely =
      !unit.defined && (middle < kUnlikelyNear || middle > kUnlikelyFar);
  const bool much = kept == 0 || (dropped >= kMuchDropped && areDefaults (limits));
  if (!much && !unlikely)
    return {};
  const auto [least, most] = std::minmax_element (measured.begin(), measured.end());
  std::string text =
      name + ": depth is " + metresText (*least) + " to " + metresText (*most) + " m";
  if (unit.scale)
    text += " with --depth-scale " + generalText (*unit.scale);
  if (much && (kept > 0 || !unlikely))
    text += ", and " + fixedText (100.0 * dropped, 0) + " % is dropped, not between " +
            limitsText (limits, unit.optional);
  text += "; " + remedy (middle, unit);
  if (kept == 0)
    throw UsageError (text);
  return text;
}

} // namespace pcl_msf::tool
