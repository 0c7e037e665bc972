// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <pcl_msf/io/undistortion.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <cmath>
#include <ostream>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;

/** A generated pair of half VGA size and the error that it may leave. */
struct Case {
  SceneKind scene;
  MotionSize motion;
  Sensor sensor;
  double limit; ///< pixels, mean over points seen in both frames
};

std::ostream&
operator<< (std::ostream& out, const Case& c)
{
  return out << "scene " << static_cast<int> (c.scene) << " motion "
             << static_cast<int> (c.motion) << " sensor "
             << static_cast<int> (c.sensor);
}

SyntheticSequence
pair (const Case& c)
{
  SequenceOptions options;
  options.scene = c.scene;
  options.motion = c.motion;
  options.sensor = c.sensor;
  options.width = 320;
  options.height = 240;
  options.frames = 2;
  return synthesize (options);
}

SceneFlow
estimate (const SyntheticSequence& sequence, const SolverParameters& solver = {})
{
  const auto frame = [&] (int k) {
    return RgbdFrame::fromImages (
        sequence.frames[k].color, sequence.frames[k].depth, sequence.camera);
  };
  const RgbdFrame reference = frame (0);
  return SceneFlowEstimator ({}, solver)
      .estimate (reference, frame (1), Oversegmentation::fromFrame (reference));
}

/** Mean end-point error over visible points with depth; unknown flow counts as none. */
double
meanError (const SceneFlow& result, const SyntheticSequence& sequence)
{
  const GroundTruth& truth = sequence.truth[1];
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < truth.flow.rows; ++y)
    for (int x = 0; x < truth.flow.cols; ++x) {
      const cv::Vec2f t = truth.flow.at<cv::Vec2f> (y, x);
      const bool counts = truth.visible.at<unsigned char> (y, x) == 255 &&
                          sequence.frames[0].depth.at<float> (y, x) > 0.0f;
      if (!counts || std::isnan (t[0]))
        continue;
      cv::Vec2f f = result.flow.at<cv::Vec2f> (y, x);
      if (std::isnan (f[0]))
        f = {0.0f, 0.0f};
      sum += cv::norm (f - t);
      ++count;
    }
  return sum / count;
}

class GeneratedScenes : public testing::TestWithParam<Case> {};

TEST_P (GeneratedScenes, AreFollowed)
{
  const SyntheticSequence sequence = pair (GetParam());
  const SceneFlow result = estimate (sequence);
  EXPECT_LT (meanError (result, sequence), GetParam().limit);
  EXPECT_NE (result.report.stop_reason, StopReason::NumericalFailure);
}

// Rigid parts reach a tenth of a pixel, soft ones a quarter; fast ones and noisy ones
// half a pixel, mostly a few pixels wide strips beside what they uncover.
INSTANTIATE_TEST_SUITE_P (
    All,
    GeneratedScenes,
    testing::Values (
        Case{SceneKind::StaticRoom, MotionSize::Easy, Sensor::Ideal, 0.1},
        Case{SceneKind::StaticRoom, MotionSize::Easy, Sensor::Kinect, 0.25},
        Case{SceneKind::MultiBody, MotionSize::Easy, Sensor::Ideal, 0.1},
        Case{SceneKind::MultiBody, MotionSize::Large, Sensor::Ideal, 0.5},
        Case{SceneKind::Articulated, MotionSize::Easy, Sensor::Ideal, 0.1},
        Case{SceneKind::Articulated, MotionSize::Easy, Sensor::Kinect, 0.25},
        Case{SceneKind::Bending, MotionSize::Easy, Sensor::Ideal, 0.25},
        Case{SceneKind::Breathing, MotionSize::Easy, Sensor::Ideal, 0.25}));

TEST (Distortion, TakenOutLeavesWhatAnIdealCameraWouldGive)
{
  const Case room{SceneKind::StaticRoom, MotionSize::Large, Sensor::Ideal, 0.0};
  const SyntheticSequence ideal = pair (room);
  SequenceOptions options = ideal.options;
  options.effects.distortion = {0.2624, -0.9531, -0.0054, 0.0026, 1.1633};
  SyntheticSequence sequence = synthesize (options);
  const double bent = meanError (estimate (sequence), sequence);
  for (SyntheticFrame& frame : sequence.frames) {
    io::RgbdImages images{frame.color, frame.depth, sequence.camera};
    io::undistort (images, options.effects.distortion);
    frame = {images.color, images.depth};
  }
  const double freed = meanError (estimate (sequence), sequence);
  EXPECT_LT (freed, meanError (estimate (ideal), ideal) + 0.03);
  EXPECT_LT (freed, 0.3 * bent);
}

TEST (BlendedMotions, FollowSoftSurfacesBetter)
{
  const SyntheticSequence sequence =
      pair ({SceneKind::Breathing, MotionSize::Easy, Sensor::Ideal, 0.0});
  SolverParameters solver;
  solver.refine_flow = false;
  const double blended = meanError (estimate (sequence, solver), sequence);
  solver.blend_motions = false;
  const double apart = meanError (estimate (sequence, solver), sequence);
  EXPECT_LT (blended, apart);
}

TEST (BlendedMotions, LeaveASingleRigidBodyAsItIs)
{
  const SyntheticSequence sequence =
      pair ({SceneKind::StaticRoom, MotionSize::Easy, Sensor::Ideal, 0.0});
  const RgbdFrame frame = RgbdFrame::fromImages (
      sequence.frames[0].color, sequence.frames[0].depth, sequence.camera);
  SegmentationParameters single;
  single.method = SegmentationMethod::Single;
  const Oversegmentation segments = Oversegmentation::fromFrame (frame, single);
  const RgbdFrame target = RgbdFrame::fromImages (
      sequence.frames[1].color, sequence.frames[1].depth, sequence.camera);
  SolverParameters solver;
  const SceneFlow blended =
      SceneFlowEstimator ({}, solver).estimate (frame, target, segments);
  solver.blend_motions = false;
  const SceneFlow apart =
      SceneFlowEstimator ({}, solver).estimate (frame, target, segments);
  const cv::Mat known = apart.flow == apart.flow;
  EXPECT_EQ (cv::norm (blended.displacement, apart.displacement, cv::NORM_INF), 0.0);
  EXPECT_GT (cv::countNonZero (known.reshape (1)), 0);
}

} // namespace
