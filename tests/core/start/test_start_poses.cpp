// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/start/flow_hypotheses.h"
#include "support/room.h"
#include <pcl_msf/errors.h>

#include <limits>

namespace {

using namespace pcl_msf;

class StartPoses : public test::Room {
protected:
  /** What each segment's first point says: the motion of its body. */
  std::vector<RigidPose>
  truePoses () const
  {
    std::vector<RigidPose> poses (segments_.size());
    for (int y = scene_.height - 1; y >= 0; --y)
      for (int x = scene_.width - 1; x >= 0; --x) {
        const int k = segments_.labels().at<int> (y, x);
        if (k >= 0)
          poses[k] = scene_.motions[view_.body.at<int> (y, x)];
      }
    return poses;
  }

  SceneFlow
  estimateFrom (const std::vector<RigidPose>& start,
                const EnergyParameters& energy = {},
                SolverParameters solver = alone()) const
  {
    return SceneFlowEstimator (energy, solver)
        .estimateFrom (reference_, current_, segments_, start);
  }
};

TEST (CoarseFlow, IsTheSameAsEnlarged)
{
  for (const int level : {0, 1, 2}) {
    CoarseFlow coarse{cv::Mat (7, 9, CV_32FC2), level};
    cv::randu (coarse.flow, -5.0, 5.0);
    cv::Mat full;
    const cv::Size size (9 << level, 7 << level);
    cv::resize (coarse.flow, full, size, 0, 0, cv::INTER_LINEAR);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        EXPECT_LT (
            cv::norm (coarse.at (x, y) - (1 << level) * full.at<cv::Vec2f> (y, x)),
            1e-4)
            << "level " << level << ", pixel " << x << " " << y;
  }
}

TEST_F (StartPoses, AreKeptWhereNothingIsToImproveThem)
{
  EnergyParameters energy;
  energy.neighbors = 0;
  SolverParameters solver = alone();
  solver.max_iterations = 0;
  solver.merge_bodies = false;
  std::vector<RigidPose> start = truePoses();
  for (std::size_t k = 0; k < start.size(); ++k)
    start[k].parameters[3] += 1e-4 * static_cast<double> (k % 7);
  const SceneFlow result = estimateFrom (start, energy, solver);
  for (std::size_t k = 0; k < start.size(); ++k)
    EXPECT_EQ (result.segments[k].current_from_reference.parameters,
               start[k].parameters)
        << "segment " << k;
}

TEST_F (StartPoses, TrueOnesNeedNoProposals)
{
  SolverParameters solver = alone();
  solver.flow_proposals = false;
  EXPECT_LT (mean (errors (estimateFrom (truePoses(), {}, solver))), 0.25);
}

TEST_F (StartPoses, AreDescendedFrom)
{
  // Half a pixel off at 2.5 m, each segment for itself.
  std::vector<RigidPose> start = truePoses();
  for (std::size_t k = 0; k < start.size(); ++k)
    start[k].parameters[3] += (k % 2 == 0 ? 1.25 : -1.25) / scene_.camera.fx;
  EXPECT_LT (mean (errors (estimateFrom (start))), 0.25);
}

TEST_F (StartPoses, NumberOfThreadsChangesNothing)
{
  SolverParameters two = alone();
  two.threads = 2;
  const SceneFlow a = estimateFrom (truePoses());
  const SceneFlow b = estimateFrom (truePoses(), {}, two);
  ASSERT_EQ (a.segments.size(), b.segments.size());
  for (std::size_t k = 0; k < a.segments.size(); ++k)
    EXPECT_EQ (a.segments[k].current_from_reference.parameters,
               b.segments[k].current_from_reference.parameters);
}

TEST_F (StartPoses, OtherNumbersAndUnusableOnesAreRefused)
{
  std::vector<RigidPose> start = truePoses();
  start[3].parameters[4] = std::numeric_limits<double>::infinity();
  EXPECT_THROW (estimateFrom (start), InvalidInput);
  start = truePoses();
  start.pop_back();
  EXPECT_THROW (estimateFrom (start), InvalidInput);
  EXPECT_THROW (estimateFrom ({}), InvalidInput);
}

} // namespace
