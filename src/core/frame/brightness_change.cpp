// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/brightness_change.h"

#include "core/base/order_statistics.h"
#include "core/frame/light_change.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

double
medianOf (std::vector<float> values) // a copy, to be sorted
{
  return median (values);
}

/** Means and standard deviations of the pairs within the limit. */
struct Moments {
  double mean0{0}, mean1{0}, spread0{0}, spread1{0};
  std::size_t count{0};
};

Moments
momentsOfInliers (const std::vector<float>& a,
                  const std::vector<float>& b,
                  const std::vector<float>& residual,
                  double limit)
{
  Moments m;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (residual[i] <= limit) {
      ++m.count;
      m.mean0 += a[i];
      m.mean1 += b[i];
      aa += static_cast<double> (a[i]) * a[i];
      bb += static_cast<double> (b[i]) * b[i];
    }
  const auto n = static_cast<double> (std::max<std::size_t> (1, m.count));
  m.mean0 /= n;
  m.mean1 /= n;
  m.spread0 = std::sqrt (std::max (0.0, aa / n - m.mean0 * m.mean0));
  m.spread1 = std::sqrt (std::max (0.0, bb / n - m.mean1 * m.mean1));
  return m;
}

} // namespace

BrightnessChange
fitExposureChange (const std::vector<float>& a,
                   const std::vector<float>& b,
                   const BrightnessTuning& tuning)
{
  const auto min_pairs = static_cast<std::size_t> (tuning.min_pairs);
  if (a.size() < min_pairs)
    return {};
  double gain = 1.0;
  double offset = medianOf (b) - medianOf (a);
  std::vector<float> residual (a.size());
  for (int round = 0; round < tuning.rounds; ++round) {
    for (std::size_t i = 0; i < a.size(); ++i)
      residual[i] = static_cast<float> (std::abs (gain * a[i] + offset - b[i]));
    const double limit = std::max (tuning.inlier_mads * medianOf (residual), 1e-3);
    const Moments m = momentsOfInliers (a, b, residual, limit);
    if (m.count < min_pairs)
      return {};
    const bool contrast =
        m.spread0 > tuning.min_spread && m.spread1 > tuning.min_spread;
    gain = contrast ? std::clamp (m.spread1 / m.spread0, 0.5, 2.0) : 1.0;
    offset = m.mean1 - gain * m.mean0;
  }
  return {static_cast<float> (gain), static_cast<float> (offset)};
}

BrightnessChange
fitBrightnessChange (const MatchedIntensities& matches, const BrightnessTuning& tuning)
{
  BrightnessChange change =
      fitExposureChange (matches.reference, matches.current, tuning);
  change.local = lightChanged (matches, change, tuning);
  if (change.local)
    change.offset = 0.0f;
  return change;
}

} // namespace pcl_msf
