// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

#include <cmath>
#include <cstddef>

namespace pcl_msf::io {

namespace {

/** Fits a line pixel = focal * slope + center by least squares. */
class LineFit {
public:
  void
  add (double slope, double pixel)
  {
    ++n_;
    s_ += slope;
    p_ += pixel;
    ss_ += slope * slope;
    sp_ += slope * pixel;
    pp_ += pixel * pixel;
  }
  double
  focal () const
  {
    return (n_ * sp_ - s_ * p_) / (n_ * ss_ - s_ * s_);
  }
  double
  center () const
  {
    return (p_ - focal() * s_) / n_;
  }
  /** Mean squared distance of the pixels from the line. */
  double
  residual () const
  {
    const double variance = pp_ / n_ - (p_ / n_) * (p_ / n_);
    const double slope_variance = ss_ / n_ - (s_ / n_) * (s_ / n_);
    return variance - focal() * focal() * slope_variance;
  }
  double
  size () const
  {
    return n_;
  }

private:
  double n_{0.0}, s_{0.0}, p_{0.0}, ss_{0.0}, sp_{0.0}, pp_{0.0};
};

} // namespace

PinholeCamera
fitCamera (const pcl::PointCloud<pcl::PointXYZRGBA>& cloud, const std::string& path)
{
  constexpr double kFewest = 100.0;
  constexpr double kLargestRms = 2.0;
  LineFit x_fit, y_fit;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const pcl::PointXYZRGBA& p = cloud[i];
    if (!(p.z > 0.0F) || !std::isfinite (p.x) || !std::isfinite (p.y))
      continue;
    x_fit.add (double{p.x} / p.z, static_cast<double> (i % cloud.width));
    y_fit.add (double{p.y} / p.z, static_cast<double> (i / cloud.width));
  }
  const PinholeCamera camera{
      x_fit.focal(), y_fit.focal(), x_fit.center(), y_fit.center()};
  const bool fits = x_fit.size() >= kFewest &&
                    camera.isValid (static_cast<int> (cloud.width),
                                    static_cast<int> (cloud.height)) &&
                    x_fit.residual() + y_fit.residual() < kLargestRms * kLargestRms;
  if (!fits)
    throw IoError (path +
                   ": camera: the points are not those of a pinhole camera in its "
                   "own frame; give the camera");
  return camera;
}

} // namespace pcl_msf::io
