// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/cloud_conversions.h>

#include <algorithm>
#include <locale>
#include <sstream>

namespace pcl_msf {

namespace {

constexpr double kLargestError = 1.0; // pixels, of an estimated camera

/** Calls f (u, v, x / z, y / z) for the valid points of every `step`-th row. */
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

/** Straight line pixel = focal * slope + center by least squares. */
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

} // namespace

cv::Mat
depthImage (const cv::Mat& points)
{
  cv::Mat depth;
  cv::extractChannel (points, depth, 2);
  return depth;
}

void
normalizeIntensity (const std::vector<cv::Mat*>& images)
{
  double largest = 0.0;
  for (const cv::Mat* image : images) {
    if (image->type() != CV_32FC1 || image->empty())
      return;
    double maximum = 0.0;
    cv::minMaxLoc (*image, nullptr, &maximum);
    largest = std::max (largest, maximum);
  }
  const double unit = largest <= 1.0 ? 1.0 : std::max (largest, 255.0);
  for (cv::Mat* image : images)
    *image = cv::max (*image / unit, 0.0);
}

void
normalizeIntensity (cv::Mat& first, cv::Mat& second)
{
  normalizeIntensity ({&first, &second});
}

cv::Mat
normalImage (const pcl::PointCloud<pcl::Normal>& normals)
{
  requireOrganized (normals, "normal cloud");
  return detail::mapPoints<cv::Vec3f> (normals, [] (const pcl::Normal& n) {
    return cv::Vec3f (n.normal_x, n.normal_y, n.normal_z);
  });
}

cv::Mat
labelImage (const pcl::PointCloud<pcl::Label>& labels)
{
  requireOrganized (labels, "label cloud");
  return detail::mapPoints<int> (labels, [] (const pcl::Label& l) {
    constexpr std::uint32_t largest = std::numeric_limits<int>::max();
    return l.label <= largest ? static_cast<int> (l.label) : -1;
  });
}

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
estimateCamera (const cv::Mat& points, PinholeCamera& camera, std::string* why)
{
  LineFit x;
  LineFit y;
  forEachRay (points, [&] (int u, int v, double slope_x, double slope_y) {
    x.add (u, slope_x);
    y.add (v, slope_y);
  });
  const PinholeCamera fit{x.focal(), y.focal(), x.center(), y.center()};
  const double error = projectionError (points, fit);
  std::ostringstream text;
  text.imbue (std::locale::classic());
  if (std::isnan (error))
    text << "no point has a depth, so there is no camera to estimate";
  else if (!fit.isValid (points.cols, points.rows))
    text << "the points fix no camera (fx " << fit.fx << ", fy " << fit.fy << ")";
  else if (error > kLargestError)
    text << "the points miss their pixels by " << error
         << " px: not a pinhole image in the camera's frame (x right, y down, z "
            "forward)";
  else {
    camera = fit;
    return true;
  }
  if (why)
    *why = text.str();
  return false;
}

} // namespace pcl_msf
