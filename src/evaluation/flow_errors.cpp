// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/order_statistics.h"
#include "evaluation/check_images.h"
#include <pcl_msf/evaluation/flow_errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_msf::evaluation {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kOutlierPixels = 3.0;
constexpr double kOutlierShare = 0.05;

template <int n>
bool
isKnown (const cv::Vec<float, n>& v)
{
  float sum = 0.0f;
  for (int i = 0; i < n; ++i)
    sum += v[i];
  return std::isfinite (sum);
}

/** Visits all scored pixels; an unknown estimate is given as zero. */
template <int n, typename Visitor>
void
visit (const cv::Mat& estimate,
       const cv::Mat& truth,
       const cv::Mat& mask,
       const Visitor& visitor)
{
  using Vector = cv::Vec<float, n>;
  for (int y = 0; y < truth.rows; ++y) {
    const auto* e = estimate.ptr<Vector> (y);
    const auto* t = truth.ptr<Vector> (y);
    const auto* m = mask.ptr<unsigned char> (y);
    for (int x = 0; x < truth.cols; ++x)
      if (m[x] == 255 && isKnown (t[x])) {
        const bool known = isKnown (e[x]);
        visitor (cv::Point (x, y), known ? e[x] : Vector(), t[x], known);
      }
  }
}

double
rootMeanSquare (const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double v : values)
    sum += v * v;
  return std::sqrt (sum / static_cast<double> (values.size()));
}

double
shareBelow (const std::vector<double>& values, double limit)
{
  const auto below = std::count_if (
      values.begin(), values.end(), [limit] (double v) { return v < limit; });
  return static_cast<double> (below) / static_cast<double> (values.size());
}

/** Angle between (u, v, 1) and (ut, vt, 1), degrees; exact for small angles, too. */
double
angleBetween (const cv::Vec2f& a, const cv::Vec2f& b)
{
  const cv::Vec3d p (a[0], a[1], 1.0), q (b[0], b[1], 1.0);
  return std::atan2 (cv::norm (p.cross (q)), p.dot (q)) * 180.0 / CV_PI;
}

} // namespace

FlowErrors::FlowErrors()
: coverage (kNan), epe (kNan), median (kNan), rms (kNan), angle (kNan), outliers (kNan)
{}

SceneFlowErrors::SceneFlowErrors()
: coverage (kNan)
, epe (kNan)
, median (kNan)
, rms (kNan)
, under_5cm (kNan)
, under_1cm (kNan)
{}

double
mean (const std::vector<double>& values)
{
  if (values.empty())
    return kNan;
  return std::accumulate (values.begin(), values.end(), 0.0) /
         static_cast<double> (values.size());
}

double
median (std::vector<double> values)
{
  if (values.empty())
    return kNan;
  const std::size_t half = values.size() / 2;
  const double upper = nthSmallest (values, half);
  return values.size() % 2 == 1 ? upper
                                : 0.5 * (upper + nthSmallest (values, half - 1));
}

cv::Mat
scoredPoints (const cv::Mat& depth, const cv::Mat& visible, ScoredPoints set)
{
  requireImage ("depth", depth, CV_32FC1, depth.size());
  if (!visible.empty())
    requireImage ("visible", visible, CV_8UC1, depth.size());
  cv::Mat mask (depth.size(), CV_8UC1, cv::Scalar (0));
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x) {
      const float z = depth.at<float> (y, x);
      const bool seen = visible.empty() || visible.at<unsigned char> (y, x) == 255;
      const bool wanted =
          set == ScoredPoints::All || seen == (set == ScoredPoints::Visible);
      if (z > 0.0f && std::isfinite (z) && wanted)
        mask.at<unsigned char> (y, x) = 255;
    }
  return mask;
}

FlowErrors
flowErrors (const cv::Mat& flow, const cv::Mat& truth, const cv::Mat& mask)
{
  requireImage ("flow", flow, CV_32FC2, truth.size());
  requireImage ("true flow", truth, CV_32FC2, truth.size());
  requireImage ("mask", mask, CV_8UC1, truth.size());
  std::vector<double> errors, angles;
  long known_count = 0, outliers = 0;
  visit<2> (flow,
            truth,
            mask,
            [&] (const cv::Point&, const cv::Vec2f& e, const cv::Vec2f& t, bool known) {
              const double error = cv::norm (e - t);
              errors.push_back (error);
              angles.push_back (angleBetween (e, t));
              known_count += known ? 1 : 0;
              const double limit =
                  std::max (kOutlierPixels, kOutlierShare * cv::norm (t));
              outliers += error > limit ? 1 : 0;
            });
  FlowErrors result;
  if (errors.empty())
    return result;
  const auto n = static_cast<double> (errors.size());
  result.points = static_cast<long> (errors.size());
  result.coverage = static_cast<double> (known_count) / n;
  result.epe = mean (errors);
  result.rms = rootMeanSquare (errors);
  result.angle = mean (angles);
  result.outliers = static_cast<double> (outliers) / n;
  result.median = evaluation::median (std::move (errors));
  return result;
}

cv::Mat
endPointErrors (const cv::Mat& flow, const cv::Mat& truth)
{
  requireImage ("flow", flow, CV_32FC2, truth.size());
  requireImage ("true flow", truth, CV_32FC2, truth.size());
  cv::Mat errors (truth.size(), CV_32FC1, cv::Scalar (kNan));
  const cv::Mat all (truth.size(), CV_8UC1, cv::Scalar (255));
  visit<2> (flow,
            truth,
            all,
            [&] (const cv::Point& pixel, const cv::Vec2f& e, const cv::Vec2f& t, bool) {
              errors.at<float> (pixel) = static_cast<float> (cv::norm (e - t));
            });
  return errors;
}

SceneFlowErrors
sceneFlowErrors (const cv::Mat& displacement, const cv::Mat& truth, const cv::Mat& mask)
{
  requireImage ("displacement", displacement, CV_32FC3, truth.size());
  requireImage ("true scene flow", truth, CV_32FC3, truth.size());
  requireImage ("mask", mask, CV_8UC1, truth.size());
  std::vector<double> errors;
  long known_count = 0;
  visit<3> (displacement,
            truth,
            mask,
            [&] (const cv::Point&, const cv::Vec3f& e, const cv::Vec3f& t, bool known) {
              errors.push_back (cv::norm (e - t));
              known_count += known ? 1 : 0;
            });
  SceneFlowErrors result;
  if (errors.empty())
    return result;
  result.points = static_cast<long> (errors.size());
  result.coverage =
      static_cast<double> (known_count) / static_cast<double> (errors.size());
  result.epe = mean (errors);
  result.rms = rootMeanSquare (errors);
  result.under_5cm = shareBelow (errors, 0.05);
  result.under_1cm = shareBelow (errors, 0.01);
  result.median = evaluation::median (std::move (errors));
  return result;
}

} // namespace pcl_msf::evaluation
