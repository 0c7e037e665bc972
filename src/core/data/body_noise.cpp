// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data/body_noise.h"

#include "core/base/order_statistics.h"
#include "core/base/parallel_for.h"
#include "core/data/point_residuals.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

/** Sizes of a body's residuals, in standard deviations of the noise model. */
struct Residuals {
  std::vector<float> brightness;
  std::vector<float> icp;
};

void
addResiduals (
    const DataTerm& data, const RigidPose& pose, int segment, int step, Residuals& out)
{
  const SegmentPixels& p = data.pixels();
  const PointRange all{p.begin[segment], p.begin[segment + 1], step};
  forEachSeen (data, pose, all, [&] (int i, const PointResiduals& r) {
    if (p.brightness_scale[i] > 0.0f)
      out.brightness.push_back (std::abs (r.brightness));
    if (p.icp_scale[i] > 0.0f)
      out.icp.push_back (std::abs (r.icp));
  });
}

/** One over the robust spread, in [1, limit]. */
float
sharpness (std::vector<float>& sizes, int least, double limit)
{
  if (static_cast<int> (sizes.size()) < least)
    return 1.0f;
  const double spread = kMadToSigma * median (sizes);
  return static_cast<float> (1.0 / std::clamp (spread, 1.0 / limit, 1.0));
}

} // namespace

void
rescaleBodyNoise (const std::vector<PairTerms>& terms,
                  const WindowState& state,
                  const BodyNoiseTuning& tuning,
                  int threads,
                  SegmentPixels& pixels)
{
  std::vector<std::vector<int>> segments (state.bodies());
  for (std::size_t k = 0; k < state.body_of.size(); ++k)
    segments[state.body_of[k]].push_back (static_cast<int> (k));
  const int bodies = static_cast<int> (segments.size());
  parallelFor (threads, bodies, 1, [&] (int b) {
    if (static_cast<int> (segments[b].size()) < tuning.rigid)
      return;
    int points = 0;
    for (const int k : segments[b])
      points += pixels.size (k);
    Residuals residuals;
    for (const PairTerms& pair : terms)
      for (const int k : segments[b])
        addResiduals (*pair.all,
                      state.poses[pair.pair][b],
                      k,
                      std::max (1, points / tuning.samples),
                      residuals);
    const float brightness =
        sharpness (residuals.brightness, tuning.least_samples, tuning.most_brightness);
    const float icp = sharpness (residuals.icp, tuning.least_samples, tuning.most_icp);
    for (const int k : segments[b])
      for (int i = pixels.begin[k]; i < pixels.begin[k + 1]; ++i) {
        pixels.brightness_scale[i] *= brightness;
        pixels.icp_scale[i] *= icp;
      }
  });
}

} // namespace pcl_msf
