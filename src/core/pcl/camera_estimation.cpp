// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "core/pcl/camera_cause.h"
#include "core/pcl/ray_fit.h"
#include <pcl_msf/cloud_conversions.h>

#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

// Pixels, of the camera estimated from a cloud: what rounding and filters leave.
constexpr double kOwnError = 1.0;
// Pixels, of a camera from elsewhere. Half-pixel conventions, a rounded principal point
// and what lens distortion calibration leaves stay below; a mirrored, moved or turned
// cloud and the camera of another sensor or resolution miss by tens.
constexpr double kGivenError = 2.0;

std::string
missText (double error)
{
  if (std::isnan (error))
    return "no point has a z > 0, as seen by a camera";
  PlainStream text;
  text.precision (3);
  text << "the points miss their pixels by " << error << " px (median)";
  return text.str();
}

bool
isMeasured (const cv::Vec3f& p)
{
  return std::isfinite (p[0] + p[1] + p[2]) && p != cv::Vec3f();
}

/** Why the points can be held against no camera, whichever; empty when they can. */
std::string
whyOpen (const cv::Mat& points)
{
  cv::Rect extent;
  cv::Vec2d first;
  bool one_ray = true;
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u) {
      const auto& p = points.at<cv::Vec3f> (v, u);
      if (!isMeasured (p))
        continue;
      const cv::Vec2d slopes (double (p[0]) / p[2], double (p[1]) / p[2]);
      if (extent.empty())
        first = slopes;
      one_ray = one_ray && slopes == first;
      extent |= cv::Rect (u, v, 1, 1);
    }
  if (extent.empty())
    return "no point has a depth, so there is no camera to estimate";
  if (extent.width == 1 || extent.height == 1)
    return std::string ("all points with a depth lie in one ") +
           (extent.width == 1 ? "column" : "row") + ", which fixes no camera";
  if (one_ray)
    return "x / z and y / z are the same everywhere: fill x and y, too";
  return {};
}

PinholeCamera
leastSquaresCamera (const cv::Mat& points)
{
  LineFit x;
  LineFit y;
  forEachRay (points, [&] (int u, int v, double slope_x, double slope_y) {
    x.add (u, slope_x);
    y.add (v, slope_y);
  });
  return {x.focal(), y.focal(), x.center(), y.center()};
}

} // namespace

double
projectionError (const cv::Mat& points, const PinholeCamera& camera)
{
  double sum = 0.0;
  double n = 0.0;
  forEachRay (points, [&] (int u, int v, double x, double y) {
    const double du = camera.fx * x + camera.cx - u;
    const double dv = camera.fy * y + camera.cy - v;
    sum += du * du + dv * dv;
    n += 1.0;
  });
  return n > 0.0 ? std::sqrt (sum / n) : std::numeric_limits<double>::quiet_NaN();
}

bool
fitsCamera (const cv::Mat& points, const PinholeCamera& camera, std::string* why)
{
  std::string problem;
  if (camera.isValid (points.cols, points.rows, &problem)) {
    const double error = medianProjectionError (points, camera);
    if (error <= kGivenError)
      return true;
    problem = whyOpen (points);
    if (problem.empty())
      problem = missText (error) + " of the camera " + cameraText (camera) + ": " +
                causeOfMisfit (points, &camera);
  }
  if (why)
    *why = problem;
  return false;
}

bool
estimateCamera (const cv::Mat& points, PinholeCamera& camera, std::string* why)
{
  PinholeCamera fit = leastSquaresCamera (points);
  bool valid = fit.isValid (points.cols, points.rows);
  double error = projectionError (points, fit);
  if (!valid || error > kOwnError) { // a few wild points spoil least squares
    fit = robustCamera (points);
    valid = fit.isValid (points.cols, points.rows);
    error = medianProjectionError (points, fit);
  }
  if (valid && error <= kOwnError) {
    camera = fit;
    return true;
  }
  if (!why)
    return false;
  *why = whyOpen (points);
  const bool upright = fit.fx > 0.0 && fit.fy > 0.0;
  if (why->empty() && !valid && upright && error <= kOwnError) {
    fit.isValid (points.cols, points.rows, why); // a far part of an image, perhaps
    return false;
  }
  if (why->empty())
    *why = (valid ? missText (error) : "the points fix no camera") + ": " +
           causeOfMisfit (points, nullptr);
  return false;
}

} // namespace pcl_msf
