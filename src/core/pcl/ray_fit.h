// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

#include <algorithm>
#include <vector>

namespace pcl_msf {

/** \brief Where a coordinate is measured, pixels, against the ratio that a pinhole
 * camera maps to it: pixel = focal * slope + center. */
struct RaySample {
  double pixel;
  double slope;
};

struct RayLine {
  double focal;
  double center;
};

/** \brief A line that up to a quarter of wild samples, however far off, cannot move.
 *
 * The slope is the noisy quantity, so it is fitted over the exact pixel: the median of
 * the gradients between samples half of the list apart in the order of their pixels
 * (Theil and Sen), then least squares over the better half.
 * \return focal 0 when the samples fix no line */
RayLine
robustLine (std::vector<RaySample> samples);

/** \brief Median distance between the projections of the points with z > 0 and their
 * pixels. \return pixels; NaN without such points */
double
medianProjectionError (const cv::Mat& points, const PinholeCamera& camera);

/** \brief Both lines of a camera by robustLine. \return fx or fy 0 when there is none
 */
PinholeCamera
robustCamera (const cv::Mat& points);

/** \brief The upper median. \return NaN of nothing */
double
medianOf (std::vector<double> values);

/** \brief Calls f (u, v, x / z, y / z) for the points with z > 0 of every `step`-th
 * row: 128 rows are sample enough. */
template <typename Function>
void
forEachRay (const cv::Mat& points, Function f)
{
  const int step = std::max (1, points.rows / 128);
  for (int v = 0; v < points.rows; v += step)
    for (int u = 0; u < points.cols; ++u) {
      const auto& p = points.at<cv::Vec3f> (v, u);
      if (p[2] > 0.0f)
        f (u, v, double (p[0]) / p[2], double (p[1]) / p[2]);
    }
}

/** \brief Straight line pixel = focal * slope + center by least squares. */
class LineFit {
public:
  void
  add (double pixel, double slope)
  {
    ++n_;
    const double from_mean = slope - slope_;
    slope_ += from_mean / n_;
    pixel_ += (pixel - pixel_) / n_;
    variance_ += from_mean * (slope - slope_);
    covariance_ += from_mean * (pixel - pixel_);
  }
  double
  focal () const
  {
    return variance_ > 0.0 ? covariance_ / variance_ : 0.0;
  }
  double
  center () const
  {
    return pixel_ - focal() * slope_;
  }

private:
  double n_{0.0};
  double slope_{0.0};
  double pixel_{0.0};
  double variance_{0.0};
  double covariance_{0.0};
};

} // namespace pcl_msf
