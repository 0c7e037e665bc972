// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/analytic_scene.h"
#include "support/points.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <functional>

namespace {

using namespace pcl_msf;
using testing::HasSubstr;

/** The room with the moving box, and what the estimator makes of it. */
class Room : public testing::Test {
protected:
  Room()
  {
    view_.depth (kHole) = std::nanf ("");
    reference_ = scene_.frame (view_);
    current_ = scene_.frame (scene_.render (true));
    SegmentationParameters cut;
    cut.segment_size = 16;
    segments_ = Oversegmentation::fromFrame (reference_, cut);
  }

  /** One thread where the test does not ask for more. */
  static SolverParameters
  alone ()
  {
    SolverParameters solver;
    solver.threads = 1;
    return solver;
  }

  SceneFlow
  estimate (const SolverParameters& solver = alone(), const RigidPose& guess = {}) const
  {
    return SceneFlowEstimator ({}, solver)
        .estimate (reference_, current_, segments_, guess);
  }

  /** End-point errors of the points seen in both frames, sorted. */
  std::vector<double>
  errors (const SceneFlow& result, int body = -1) const
  {
    const test::Truth truth = scene_.truth (view_);
    std::vector<double> errors;
    for (int y = 0; y < scene_.height; ++y)
      for (int x = 0; x < scene_.width; ++x) {
        const bool wanted = body < 0 || view_.body.at<int> (y, x) == body;
        if (!truth.visible.at<unsigned char> (y, x) || !wanted ||
            kHole.contains ({x, y}))
          continue;
        const double error = cv::norm (result.flow.at<cv::Vec2f> (y, x) -
                                       truth.flow.at<cv::Vec2f> (y, x));
        errors.push_back (std::isfinite (error) ? error : 100.0);
      }
    std::sort (errors.begin(), errors.end());
    return errors;
  }

  static double
  mean (const std::vector<double>& values)
  {
    double sum = 0.0;
    for (const double v : values)
      sum += v;
    return sum / static_cast<double> (values.size());
  }

  const cv::Rect kHole{20, 30, 9, 7};
  test::AnalyticScene scene_{test::roomWithBox()};
  test::View view_{scene_.render (false)};
  RgbdFrame reference_, current_;
  Oversegmentation segments_;
};

bool
sameBytes (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() && a.type() == b.type() && a.isContinuous() &&
         b.isContinuous() &&
         std::memcmp (a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST_F (Room, FlowIsRightWhereBothFramesSee)
{
  const SceneFlow result = estimate();
  const auto all = errors (result);
  const auto box = errors (result, 1);
  // Images without noise: what remains is bilinear sampling, a few hundredths of a
  // pixel. Along the box's outline a pixel's segment may be the wrong one; that strip
  // is about 3 % of the image, at 6 px apart.
  EXPECT_LT (all[all.size() / 2], 0.05);
  EXPECT_LT (mean (all), 0.25);
  EXPECT_LT (box[box.size() / 2], 0.1);
  EXPECT_LT (mean (box), 0.4);
}

TEST_F (Room, DisplacementsAreMetresAndFlowIsTheirPicture)
{
  SolverParameters solver = alone();
  solver.blend_motions = false; // each point moves with its segment alone
  const SceneFlow result = estimate (solver);
  for (int y = 0; y < scene_.height; y += 5)
    for (int x = 0; x < scene_.width; x += 5) {
      const cv::Vec3f p = result.points.at<cv::Vec3f> (y, x);
      const cv::Vec3f d = result.displacement.at<cv::Vec3f> (y, x);
      if (std::isnan (d[0]))
        continue;
      EXPECT_NEAR (p[2], view_.depth.at<float> (y, x), 1e-5);
      const Eigen::Vector2d uv =
          scene_.camera.project ({p[0] + d[0], p[1] + d[1], p[2] + d[2]});
      EXPECT_NEAR (uv.x() - x, result.flow.at<cv::Vec2f> (y, x)[0], 1e-3);
      EXPECT_NEAR (uv.y() - y, result.flow.at<cv::Vec2f> (y, x)[1], 1e-3);
      const Eigen::Vector3d q =
          result.warp ({p[0], p[1], p[2]}, result.labels.at<int> (y, x));
      EXPECT_NEAR (q.x(), p[0] + d[0], 1e-5);
    }
}

TEST_F (Room, BodiesAreTheRoomAndTheBox)
{
  const SceneFlow result = estimate();
  EXPECT_GE (result.bodies, 2);
  EXPECT_LE (result.bodies, 8);
  ASSERT_EQ (result.dominant_body, 0);
  // Where most room points and most box points belong.
  int room_dominant = 0, room = 0, box_dominant = 0, box = 0;
  for (int y = 0; y < scene_.height; ++y)
    for (int x = 0; x < scene_.width; ++x) {
      const int label = result.labels.at<int> (y, x);
      if (label < 0)
        continue;
      const bool dominant = result.segments[label].body == result.dominant_body;
      const bool on_box = view_.body.at<int> (y, x) == 1;
      (on_box ? box : room) += 1;
      (on_box ? box_dominant : room_dominant) += dominant ? 1 : 0;
    }
  EXPECT_GT (room_dominant, 0.95 * room);
  EXPECT_LT (box_dominant, 0.1 * box);
}

TEST_F (Room, DominantMotionIsTheCamerasOwn)
{
  const RigidPose found = estimate().dominant_motion;
  const RigidPose error = found * scene_.motions[0].inverse();
  EXPECT_LT (error.angle(), 0.0005);
  const Eigen::Vector3d p (0.0, 0.0, 2.5);
  EXPECT_LT ((found * p - scene_.motions[0] * p).norm(), 0.001);
}

TEST_F (Room, UnknownIsNaNAndHiddenIsSaid)
{
  const SceneFlow result = estimate();
  const test::Truth truth = scene_.truth (view_);
  int covered = 0, said_covered = 0, seen = 0, said_seen = 0;
  for (int y = 0; y < scene_.height; ++y)
    for (int x = 0; x < scene_.width; ++x) {
      const int visibility = result.visibility.at<unsigned char> (y, x);
      if (kHole.contains ({x, y})) {
        EXPECT_EQ (visibility, NoDepth);
        EXPECT_TRUE (std::isnan (result.flow.at<cv::Vec2f> (y, x)[0]));
        EXPECT_TRUE (std::isnan (result.displacement.at<cv::Vec3f> (y, x)[2]));
        EXPECT_EQ (result.labels.at<int> (y, x), -1);
        continue;
      }
      EXPECT_NE (visibility, NoDepth);
      const cv::Vec2f end = truth.flow.at<cv::Vec2f> (y, x);
      const bool inside = x + end[0] >= 0 && x + end[0] <= scene_.width - 1 &&
                          y + end[1] >= 0 && y + end[1] <= scene_.height - 1;
      if (truth.visible.at<unsigned char> (y, x)) {
        ++seen;
        said_seen += visibility == Visible ? 1 : 0;
      }
      else if (inside) {
        ++covered;
        said_covered += visibility == Occluded ? 1 : 0;
      }
      else
        EXPECT_NE (visibility, Occluded);
    }
  ASSERT_GT (covered, 50);
  EXPECT_GT (said_covered, 0.7 * covered);
  EXPECT_GT (said_seen, 0.95 * seen);
}

TEST_F (Room, SameBytesForAnyNumberOfThreadsAndEveryTime)
{
  SolverParameters solver = alone();
  solver.threads = 1;
  const SceneFlow first = estimate (solver);
  for (const unsigned threads : {1u, 2u, 5u}) {
    solver.threads = threads;
    const SceneFlow other = estimate (solver);
    EXPECT_TRUE (sameBytes (first.flow, other.flow)) << threads;
    EXPECT_TRUE (sameBytes (first.displacement, other.displacement)) << threads;
    EXPECT_TRUE (sameBytes (first.visibility, other.visibility)) << threads;
    EXPECT_EQ (first.report.final_cost.total(), other.report.final_cost.total());
    ASSERT_EQ (first.segments.size(), other.segments.size());
    for (std::size_t k = 0; k < first.segments.size(); ++k) {
      EXPECT_EQ (first.segments[k].information, other.segments[k].information);
      EXPECT_EQ (first.segments[k].body, other.segments[k].body);
    }
  }
}

TEST_F (Room, ReportTellsTheTruth)
{
  const SceneFlow result = estimate();
  const Report& report = result.report;
  EXPECT_TRUE (report.stop_reason == StopReason::Converged ||
               report.stop_reason == StopReason::IterationLimit);
  EXPECT_EQ (report.converged, report.stop_reason == StopReason::Converged);
  EXPECT_GT (report.iterations, 0);
  EXPECT_EQ (report.history.size(), static_cast<std::size_t> (report.iterations));
  EXPECT_LE (report.final_cost.total(), report.initial_cost.total());
  EXPECT_EQ (result.segments.size(), static_cast<std::size_t> (segments_.size()));
  for (const SegmentMotion& segment : result.segments)
    EXPECT_TRUE (segment.current_from_reference.isFinite());
  for (const SegmentPair& pair : result.pairs) {
    EXPECT_LT (pair.first, pair.second);
    EXPECT_GE (pair.weight, 0.0);
    EXPECT_LE (pair.weight, 1.0 + 1e-9);
  }
}

TEST_F (Room, GuessBringsHomeWhatNothingElseFinds)
{
  // Half a metre to the side, and no optical flow to suggest it.
  test::AnalyticScene far = scene_;
  far.motions.assign (2, test::turnAbout ({0, 0, 2.5}, {0.0, 0.02, 0.0}, {0.5, 0, 0}));
  const RgbdFrame current = far.frame (far.render (true));
  SolverParameters solver = alone();
  solver.flow_proposals = false;
  RigidPose guess = far.motions[0];
  guess.parameters[3] += 0.02;
  const auto off = [&] (const RigidPose& start) {
    const RigidPose found = SceneFlowEstimator ({}, solver)
                                .estimate (reference_, current, segments_, start)
                                .dominant_motion;
    const Eigen::Vector3d p (0.0, 0.0, 2.5);
    return (found * p - far.motions[0] * p).norm();
  };
  EXPECT_GT (off ({}), 0.1);
  EXPECT_LT (off (guess), 0.005);
}

TEST_F (Room, OneSegmentIsARigidScene)
{
  test::AnalyticScene rigid = scene_;
  rigid.motions[1] = rigid.motions[0];
  SegmentationParameters cut;
  cut.method = SegmentationMethod::Single;
  const SceneFlow result =
      SceneFlowEstimator ({}, alone())
          .estimate (reference_,
                     rigid.frame (rigid.render (true)),
                     Oversegmentation::fromFrame (reference_, cut));
  EXPECT_EQ (result.bodies, 1);
  EXPECT_EQ (result.segments[0].status, MotionStatus::Determined);
  EXPECT_EQ (result.segments[0].rank, 6);
  const RigidPose error = result.dominant_motion * rigid.motions[0].inverse();
  EXPECT_LT (error.angle(), 0.0003);
  EXPECT_LT (error.translation().norm(), 0.001);
}

TEST_F (Room, ProgressCanCancelAndTheResultIsUsable)
{
  int calls = 0;
  double last = 0.0;
  SolverParameters solver = alone();
  solver.progress = [&] (const Progress& p) {
    EXPECT_GE (p.fraction, last);
    EXPECT_LE (p.fraction, 1.0);
    EXPECT_EQ (p.iteration, calls + 1);
    last = p.fraction;
    return ++calls < 3;
  };
  const SceneFlow result = estimate (solver);
  EXPECT_EQ (calls, 3);
  EXPECT_EQ (result.report.stop_reason, StopReason::Cancelled);
  EXPECT_FALSE (result.report.converged);
  EXPECT_EQ (result.flow.size(), view_.depth.size());
  const auto all = errors (result);
  EXPECT_LT (all[all.size() / 2], 1.0); // the start is good already
}

TEST_F (Room, ProgressIsMonotonicToTheEnd)
{
  double last = 0.0;
  SolverParameters solver = alone();
  solver.progress = [&] (const Progress& p) {
    EXPECT_GE (p.fraction, last);
    EXPECT_LE (p.fraction, 1.0);
    EXPECT_STRNE (p.stage, "");
    last = p.fraction;
    return true;
  };
  estimate (solver);
  EXPECT_GT (last, 0.5);
}

TEST_F (Room, TimeBudgetIsKept)
{
  SolverParameters solver = alone();
  solver.max_seconds = 1e-6;
  const SceneFlow result = estimate (solver);
  EXPECT_EQ (result.report.stop_reason, StopReason::TimeLimit);
  EXPECT_FALSE (result.report.converged);
  EXPECT_EQ (result.report.iterations, 0);
  EXPECT_EQ (result.flow.size(), view_.depth.size());
  solver.max_seconds = 1000.0;
  EXPECT_NE (estimate (solver).report.stop_reason, StopReason::TimeLimit);
}

TEST_F (Room, NoIterationsStillGiveAResult)
{
  SolverParameters solver = alone();
  solver.max_iterations = 0;
  const SceneFlow result = estimate (solver);
  EXPECT_EQ (result.report.iterations, 0);
  EXPECT_EQ (result.report.stop_reason, StopReason::IterationLimit);
  EXPECT_EQ (result.flow.size(), view_.depth.size());
}

TEST_F (Room, EveryVariantOfTheEnergySolvesIt)
{
  std::vector<EnergyParameters> energies (5);
  energies[0].loss = LossType::L1;
  energies[1].loss = LossType::L2;
  energies[2].pose_difference = PoseDifference::Parameters;
  energies[2].regularizer_weight = 200.0; // radians and metres, not pixels
  energies[3].neighbors = 0;
  energies[4].regularizer_weight = 0.0;
  for (std::size_t i = 0; i < energies.size(); ++i)
    for (const LinearSolver linear :
         {LinearSolver::Cgnr, LinearSolver::SparseCholesky}) {
      SolverParameters solver = alone();
      solver.linear_solver = linear;
      const SceneFlow result = SceneFlowEstimator (energies[i], solver)
                                   .estimate (reference_, current_, segments_);
      const auto all = errors (result);
      EXPECT_LT (all[all.size() / 2], 0.15) << i;
    }
}

TEST (GeometryOnly, BumpySurfaceIsEnough)
{
  const PinholeCamera camera{150.0, 150.0, 79.5, 59.5};
  const RigidPose motion =
      test::turnAbout ({0, 0, 2}, {0.01, -0.012, 0.01}, {0.02, -0.015, 0.01});
  // z = f (x, y) of the surface's own frame, met by rays of either view.
  const auto height = [] (const Eigen::Vector3d& p) {
    return 2.0 + 0.08 * std::sin (6.0 * p.x()) * std::cos (5.0 * p.y()) +
           0.05 * std::cos (4.0 * p.x() + 7.0 * p.y());
  };
  const auto depth = [&] (const RigidPose& pose) {
    const RigidPose back = pose.inverse();
    return test::image (160, 120, [&] (int x, int y) {
      double z = 2.0;
      for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d p = back * camera.backProject (x, y, z);
        z += 0.7 * (height (p) - p.z());
      }
      return z;
    });
  };
  const RgbdFrame reference = RgbdFrame::fromImages ({}, depth ({}), camera);
  const RgbdFrame current = RgbdFrame::fromImages ({}, depth (motion), camera);
  const SceneFlow result = SceneFlowEstimator().estimate (
      reference, current, Oversegmentation::fromFrame (reference));
  const Eigen::Vector3d p (0.0, 0.0, 2.0);
  EXPECT_LT ((result.dominant_motion * p - motion * p).norm(), 0.002);
  EXPECT_LT ((result.dominant_motion * motion.inverse()).angle(), 0.001);
  EXPECT_GT (cv::countNonZero (result.visibility == Visible), 0.85 * 160 * 120);
}

TEST_F (Room, RefusesBadInputAndSaysWhy)
{
  const auto refused = [] (const std::function<void()>& call, const char* remedy) {
    try {
      call();
      ADD_FAILURE() << "accepted: " << remedy;
    }
    catch (const InvalidInput& error) {
      EXPECT_THAT (error.what(), HasSubstr (remedy));
    }
  };
  const auto run = [] (const RgbdFrame& a,
                       const RgbdFrame& b,
                       const Oversegmentation& s,
                       const RigidPose& guess = {}) {
    SceneFlowEstimator().estimate (a, b, s, guess);
  };
  const cv::Mat small (60, 80, CV_32FC1, cv::Scalar (2));
  const RgbdFrame other = RgbdFrame::fromImages (small, small, {80, 80, 40, 30});
  const RgbdFrame bare = RgbdFrame::fromImages ({}, view_.depth, scene_.camera);
  refused ([&] { run ({}, current_, segments_); }, "a frame is empty");
  refused ([&] { run (reference_, {}, segments_); }, "a frame is empty");
  refused ([&] { run (reference_, other, segments_); }, "differ in size; resample");
  refused ([&] { run (reference_, bare, segments_); }, "one frame has colour");
  refused ([&] { run (reference_, current_, {}); }, "not of the reference frame");
  refused ([&] { run (other, other, segments_); }, "not of the reference frame");
  RigidPose nan;
  nan.parameters[4] = std::nan ("");
  refused ([&] { run (reference_, current_, segments_, nan); },
           "give radians and metres");
  EnergyParameters energy;
  energy.prior_weight = 0.0;
  refused (
      [&] {
        SceneFlowEstimator (energy, {}).estimate (reference_, current_, segments_);
      },
      "prior_weight must be > 0");
  SolverParameters solver = alone();
  solver.levels = 0;
  refused ([&] { estimate (solver); }, "levels must be in [1, 10]");
}

TEST_F (Room, AbsurdGuessesDoNoHarm)
{
  for (int axis = 0; axis < 6; ++axis) {
    RigidPose guess;
    guess.parameters[axis] = 1e5;
    const auto all = errors (estimate (alone(), guess));
    EXPECT_LT (all[all.size() / 2], 0.3) << axis;
    for (const double refused : {1e39, 1e200, -1e200}) {
      guess.parameters[axis] = refused;
      EXPECT_THROW (estimate (alone(), guess), InvalidInput);
    }
  }
}

} // namespace
