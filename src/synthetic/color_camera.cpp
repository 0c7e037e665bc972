// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/color_camera.h>
#include <synthetic/lattice_noise.h>
#include <synthetic/noise_field.h>

namespace pcl_msf::synthetic {
namespace {

constexpr double noise_level = 2.5;     ///< of 255
constexpr double mosaic_length = 0.8;   ///< pixels: neighbours correlate by 0.3
constexpr double usual_exposure = 0.03; ///< share
constexpr double usual_vignette = 0.12; ///< share

void
expose (double gain, double vignette, int threads, cv::Mat& color)
{
  const double cx = 0.5 * (color.cols - 1), cy = 0.5 * (color.rows - 1);
  parallelFor (threads, color.rows, 4, [&] (int v) {
    auto* row = color.ptr<cv::Vec3d> (v);
    for (int u = 0; u < color.cols; ++u) {
      const double x = u - cx, y = v - cy;
      const double corner = (x * x + y * y) / (cx * cx + cy * cy);
      row[u] *= gain * (1.0 - vignette * corner);
    }
  });
}

void
addNoise (Sensor sensor, std::uint64_t key, int threads, cv::Mat& color)
{
  const double length = sensor == Sensor::White ? 0.0 : mosaic_length;
  for (int c = 0; c < 3; ++c) {
    const cv::Mat noise = correlatedNoise (color.size(), length, key, c, threads);
    parallelFor (threads, color.rows, 4, [&] (int v) {
      for (int u = 0; u < color.cols; ++u)
        color.at<cv::Vec3d> (v, u)[c] += noise_level * noise.at<double> (v, u);
    });
  }
}

} // namespace

void
applyColorCamera (Sensor sensor,
                  const CameraEffects& effects,
                  std::uint64_t frame,
                  int threads,
                  cv::Mat& color)
{
  const bool ideal = sensor == Sensor::Ideal;
  const double change = effects.exposure_change.value_or (ideal ? 0.0 : usual_exposure);
  const double vignette = effects.vignette.value_or (ideal ? 0.0 : usual_vignette);
  if (ideal && change == 0.0 && vignette == 0.0)
    return;
  cv::Mat exact;
  color.convertTo (exact, CV_64F);
  const double gain = 1.0 + change * (2.0 * uniformFrom (mixed (frame) + 1) - 1.0);
  expose (gain, vignette, threads, exact);
  if (!ideal)
    addNoise (sensor, frame ^ 0x5bd1e995ULL, threads, exact);
  exact.convertTo (color, CV_32F);
}

} // namespace pcl_msf::synthetic
