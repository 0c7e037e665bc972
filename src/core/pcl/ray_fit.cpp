// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/pcl/ray_fit.h"

#include "core/base/order_statistics.h"

#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

/** Least squares over the half of the samples that the line explains best. */
RayLine
refit (const std::vector<RaySample>& samples, const RayLine& line)
{
  std::vector<double> errors;
  errors.reserve (samples.size());
  for (const RaySample& s : samples)
    errors.push_back (std::abs (line.focal * s.slope + line.center - s.pixel));
  const double limit = medianOf (errors);
  LineFit fit;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (errors[i] <= limit)
      fit.add (samples[i].pixel, samples[i].slope);
  return {fit.focal(), fit.center()};
}

} // namespace

double
medianOf (std::vector<double> values)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  return median (values);
}

RayLine
robustLine (std::vector<RaySample> samples)
{
  std::stable_sort (
      samples.begin(), samples.end(), [] (const RaySample& a, const RaySample& b) {
        return a.pixel < b.pixel;
      });
  const std::size_t half = samples.size() / 2;
  std::vector<double> gradients;
  gradients.reserve (half + 1);
  for (std::size_t i = 0; i + half < samples.size(); ++i) {
    const RaySample& a = samples[i];
    const RaySample& b = samples[i + half];
    if (b.pixel > a.pixel)
      gradients.push_back ((b.slope - a.slope) / (b.pixel - a.pixel));
  }
  const double focal = 1.0 / medianOf (std::move (gradients));
  if (!std::isfinite (focal))
    return {0.0, 0.0};
  std::vector<double> centers;
  centers.reserve (samples.size());
  for (const RaySample& s : samples)
    centers.push_back (s.pixel - focal * s.slope);
  return refit (samples, {focal, medianOf (std::move (centers))});
}

double
medianProjectionError (const cv::Mat& points, const PinholeCamera& camera)
{
  std::vector<double> errors;
  forEachRay (points, [&] (int u, int v, double x, double y) {
    errors.push_back (
        std::hypot (camera.fx * x + camera.cx - u, camera.fy * y + camera.cy - v));
  });
  return medianOf (std::move (errors));
}

PinholeCamera
robustCamera (const cv::Mat& points)
{
  std::vector<RaySample> x;
  std::vector<RaySample> y;
  forEachRay (points, [&] (int u, int v, double slope_x, double slope_y) {
    x.push_back ({static_cast<double> (u), slope_x});
    y.push_back ({static_cast<double> (v), slope_y});
  });
  const RayLine right = robustLine (std::move (x));
  const RayLine down = robustLine (std::move (y));
  return {right.focal, down.focal, right.center, down.center};
}

} // namespace pcl_msf
