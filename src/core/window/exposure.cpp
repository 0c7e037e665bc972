// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/window/exposure.h"

#include "core/base/bilinear.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** Bilinear; NaN outside the image. */
float
sample (const cv::Mat& image, double x, double y)
{
  const int u = static_cast<int> (std::floor (x));
  const int v = static_cast<int> (std::floor (y));
  if (u < 0 || v < 0 || u + 1 >= image.cols || v + 1 >= image.rows)
    return std::nanf ("");
  const auto a = static_cast<float> (x - u);
  const auto b = static_cast<float> (y - v);
  const float* upper = image.ptr<float> (v) + u;
  const float* lower = image.ptr<float> (v + 1) + u;
  return bilinear (a, b, upper[0], upper[1], lower[0], lower[1]);
}

double
squaredRadius (const PinholeCamera& camera, double u, double v)
{
  const double x = (u - camera.cx) / camera.fx;
  const double y = (v - camera.cy) / camera.fy;
  return x * x + y * y;
}

} // namespace

MatchedIntensities
matchIntensities (const SegmentPixels& points,
                  const MotionState& motion,
                  const FrameLevel& level)
{
  MatchedIntensities matches;
  if (level.intensity.empty())
    return matches;
  for (int k = 0; k < points.segments(); ++k) {
    const Eigen::Matrix3d r = motion.poseOf (k).rotation();
    const Eigen::Vector3d t = motion.poseOf (k).translation();
    for (int i = points.begin[k]; i < points.begin[k + 1]; ++i) {
      const Eigen::Vector3d p (points.x[i], points.y[i], points.z[i]);
      const Eigen::Vector3d q = r * p + t;
      if (!(q.z() > 0.0))
        continue;
      const Eigen::Vector2d uv = level.camera.project (q);
      const float intensity = sample (level.intensity, uv.x(), uv.y());
      if (!std::isfinite (intensity))
        continue;
      const float w =
          level.inverse_depth.at<float> (cvRound (uv.y()), cvRound (uv.x()));
      if (w <= 0.0f || std::abs (1.0 / q.z() - w) > points.depth_tolerance[i])
        continue;
      matches.reference.push_back (points.intensity[i]);
      matches.current.push_back (intensity);
      const cv::Point2f at = placeInImage (points.pixel[i] % level.width(),
                                           points.pixel[i] / level.width(),
                                           level.intensity.size());
      matches.x.push_back (at.x);
      matches.y.push_back (at.y);
      matches.reference_radius2.push_back (
          static_cast<float> (p.head<2>().squaredNorm() / (p.z() * p.z())));
      matches.current_radius2.push_back (
          static_cast<float> (squaredRadius (level.camera, uv.x(), uv.y())));
    }
  }
  return matches;
}

double
fitFalloff (const std::vector<MatchedIntensities>& matches,
            const std::vector<BrightnessChange>& exposure,
            const FalloffTuning& tuning)
{
  double falloff = 0.0;
  for (int round = 0; round < tuning.rounds; ++round) {
    double xx = tuning.least_evidence;
    double xy = 0.0;
    for (std::size_t f = 0; f < matches.size(); ++f) {
      const MatchedIntensities& m = matches[f];
      for (std::size_t i = 0; i < m.reference.size(); ++i) {
        const double expected = exposure[f].gain * m.reference[i] + exposure[f].offset;
        const double x = expected * (m.current_radius2[i] - m.reference_radius2[i]);
        const double y = m.current[i] - expected;
        const double misfit = std::abs (y - falloff * x);
        const double weight = misfit < tuning.inlier ? 1.0 : tuning.inlier / misfit;
        xx += weight * x * x;
        xy += weight * x * y;
      }
    }
    falloff = xy / xx;
  }
  return std::clamp (falloff, -0.6, 0.2);
}

cv::Mat
correctIntensity (const FrameLevel& level,
                  const BrightnessChange& exposure,
                  double falloff)
{
  cv::Mat result (level.intensity.size(), CV_32FC1);
  for (int y = 0; y < result.rows; ++y) {
    const float* in = level.intensity.ptr<float> (y);
    float* out = result.ptr<float> (y);
    for (int x = 0; x < result.cols; ++x) {
      const double dark = 1.0 + falloff * squaredRadius (level.camera, x, y);
      out[x] = static_cast<float> ((in[x] - exposure.offset) /
                                   (exposure.gain * std::max (dark, 0.2)));
    }
  }
  return result;
}

} // namespace pcl_msf
