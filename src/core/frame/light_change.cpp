// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/light_change.h"

#include <Eigen/Cholesky>

#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/order_statistics.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr int kTerms = 23;
constexpr int kAtOnce = 64; // rows that are summed at once
using Terms = Eigen::Matrix<double, kTerms, 1, Eigen::DontAlign>;

/** Functions of an intensity and its place. */
Terms
termsAt (double i, double x, double y)
{
  const double xx = x * x;
  const double xy = x * y;
  const double yy = y * y;
  Terms t;
  t << 1.0, x, y, xx, xy, yy, xx * x, xx * y, x * yy, y * yy, xx * xx, xx * xy, xx * yy,
      xy * yy, yy * yy, i, i * x, i * y, i * xx, i * xy, i * yy, i * i, i * i * i;
  return t;
}

/** What a gain and an offset leave of matched intensities. */
class Misfits {
public:
  /** \param most pairs that are looked at, spread over all */
  Misfits (const MatchedIntensities& matches,
           const BrightnessChange& exposure,
           std::size_t most)
  {
    const std::size_t all = matches.reference.size();
    const std::size_t n = std::min (all, most);
    terms_.reserve (n);
    left_.reserve (n);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = k * all / n;
      const float in = matches.reference[i];
      terms_.push_back (termsAt (in, matches.x[i], matches.y[i]));
      left_.push_back (matches.current[i] - (exposure.gain * in + exposure.offset));
    }
  }

  /** Median size, less what some amounts of the terms explain. */
  double
  medianBeyond (const Terms& amounts) const
  {
    std::vector<double> sizes (left_.size());
    for (std::size_t i = 0; i < sizes.size(); ++i)
      sizes[i] = std::abs (left_[i] - amounts.dot (terms_[i]));
    return median (sizes);
  }

  /** Amounts that explain most. \param limit of misfits that count
   * \param ridge least information on an amount */
  Terms
  explain (const Terms& amounts, double limit, double ridge) const
  {
    Eigen::Matrix<double, kTerms, kTerms, Eigen::DontAlign> a =
        ridge * Eigen::Matrix<double, kTerms, kTerms>::Identity();
    Terms b = Terms::Zero();
    Eigen::Matrix<double, kTerms, kAtOnce, Eigen::DontAlign> rows;
    for (std::size_t first = 0; first < left_.size(); first += kAtOnce) {
      const std::size_t count = std::min<std::size_t> (kAtOnce, left_.size() - first);
      rows.setZero();
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = first + k;
        const double share = (left_[i] - amounts.dot (terms_[i])) / limit;
        const double root = 1.0 / (1.0 + share * share); // Geman and McClure's weight
        rows.col (static_cast<int> (k)) = root * terms_[i];
        b += root * left_[i] * rows.col (static_cast<int> (k));
      }
      a.selfadjointView<Eigen::Lower>().rankUpdate (rows);
    }
    return a.selfadjointView<Eigen::Lower>().ldlt().solve (b);
  }

private:
  std::vector<Terms> terms_;
  std::vector<double> left_;
};

} // namespace

bool
lightChanged (const MatchedIntensities& matches,
              const BrightnessChange& exposure,
              const BrightnessTuning& tuning)
{
  if (matches.reference.size() < static_cast<std::size_t> (tuning.min_pairs))
    return false;
  const Misfits misfits (matches, exposure, tuning.light_pairs);
  Terms amounts = Terms::Zero();
  const double before = misfits.medianBeyond (amounts);
  if (before <= tuning.least_light) // no light can explain more
    return false;
  // What light explains the first round does nearly: of most frames it is the only one.
  const double hopeless = 0.5 * (1.0 + tuning.light_explained) * before;
  double after = before;
  for (int round = 0; round < tuning.rounds && (round == 0 || after < hopeless);
       ++round) {
    const double limit = std::max (tuning.inlier_mads * after, 1e-3);
    const double unsure = limit / tuning.term_prior;
    amounts = misfits.explain (amounts, limit, unsure * unsure);
    after = misfits.medianBeyond (amounts);
  }
  return after < tuning.light_explained * before && before - after > tuning.least_light;
}

cv::Mat
localMeans (const cv::Mat& intensity, int radius)
{
  cv::Mat means;
  const int side = 2 * radius + 1;
  if (!intensity.empty())
    inThisThread ([&] {
      cv::blur (intensity, means, {side, side}, {-1, -1}, cv::BORDER_REFLECT);
    });
  return means;
}

cv::Mat
localContrast (const cv::Mat& intensity, int radius, double mean_share)
{
  if (intensity.empty())
    return {};
  return intensity - (1.0 - mean_share) * localMeans (intensity, radius);
}

} // namespace pcl_msf
