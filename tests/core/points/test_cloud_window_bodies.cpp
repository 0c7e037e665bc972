// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/cloud_flow_error.h"
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <cmath>
#include <vector>

/* Windows of bodies that move on, against each frame registered directly. */
namespace {

using namespace pcl_msf;
using pcl_msf::testing::meanError;
using synthetic::BodyClouds;

/** Mean errors over seeds, metres. */
struct Errors {
  double direct{0.0}; ///< all frames
  double window{0.0};
  double direct_last{0.0};
  double window_last{0.0};
};

Errors
errorsOf (double angle, int targets, const std::vector<unsigned>& seeds)
{
  SolverParameters solver;
  solver.threads = 2;
  const CloudFlowEstimator estimator (solver);
  Errors errors;
  const auto count = static_cast<double> (seeds.size());
  for (const unsigned seed : seeds) {
    synthetic::BodyOptions options;
    options.body = synthetic::BodyKind::Chain;
    options.angle = angle;
    options.noise = 0.001;
    options.points = 1500;
    options.seed = seed;
    const std::vector<BodyClouds> sequence =
        synthetic::synthesizeBodySequence (options, targets);
    std::vector<CloudFrame> frames{{sequence[0].source, {}}};
    for (const BodyClouds& clouds : sequence)
      frames.push_back ({clouds.target, {}});
    const std::vector<CloudFlow> flows = estimator.estimateWindow (frames);
    for (int t = 0; t < targets; ++t) {
      const BodyClouds& clouds = sequence[t];
      const double direct =
          meanError (estimator.estimate (clouds.source, clouds.target), clouds.truth);
      const double window = meanError (flows[t + 1], clouds.truth);
      errors.direct += direct / (targets * count);
      errors.window += window / (targets * count);
      errors.direct_last += t + 1 == targets ? direct / count : 0.0;
      errors.window_last += t + 1 == targets ? window / count : 0.0;
    }
  }
  return errors;
}

TEST (CloudWindowBodies, AChainIsNoWorseThanByPairs)
{
  const Errors errors = errorsOf (12.0, 2, {1, 2, 3});
  EXPECT_LT (errors.window, errors.direct);
}

/** Seeds where the way from the source leads astray; of others DECISIONS.md tells. */
TEST (CloudWindowBodies, AFarFrameIsReachedBySmallSteps)
{
  const Errors errors = errorsOf (25.0, 3, {4, 5});
  EXPECT_LT (errors.window, errors.direct);
  EXPECT_LT (errors.window_last, 0.8 * errors.direct_last);
}

} // namespace
