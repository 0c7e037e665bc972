// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/methods/lifting.h"
#include "evaluate/generated.h"
#include "evaluate/score_pair.h"
#include "evaluate/work.h"
#include "support/pose_matcher.h"

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::tool;

const float kNan = std::numeric_limits<float>::quiet_NaN();

/** Two pictures of a wall at 2 m and at 2.2 m, focal length 10, 16 x 12 pixels. */
PairData
walls ()
{
  const PinholeCamera camera{10.0, 10.0, 3.5, 2.5};
  PairData pair;
  pair.reference = {cv::Mat (12, 16, CV_8UC1, cv::Scalar (90)),
                    cv::Mat (12, 16, CV_32FC1, 2.0),
                    camera};
  pair.current = {cv::Mat (12, 16, CV_8UC1, cv::Scalar (100)),
                  cv::Mat (12, 16, CV_32FC1, cv::Scalar (2.2)),
                  camera};
  pair.reference.depth.at<float> (0, 0) = 0.0f;
  return pair;
}

cv::Vec3f
at (const Estimate& estimate, int y, int x)
{
  return estimate.displacement.at<cv::Vec3f> (y, x);
}

TEST (Lifting, TakesTheCurrentDepthAtTheTarget)
{
  Estimate estimate;
  estimate.flow = cv::Mat (12, 16, CV_32FC2, cv::Scalar (1.0, 0.0));
  estimate.flow.at<cv::Vec2f> (4, 4) = {kNan, kNan};
  const PairData pair = walls();
  liftByDepth (pair, estimate);
  // Pixel (3, 2) sees (-0.1, -0.1, 2); pixel (4, 2) of the other frame (0.11,
  // -0.11, 2.2).
  const cv::Vec3f d = at (estimate, 2, 3);
  EXPECT_NEAR (d[0], 0.21, 1e-6);
  EXPECT_NEAR (d[1], -0.01, 1e-6);
  EXPECT_NEAR (d[2], 0.2, 1e-6);
  EXPECT_TRUE (std::isnan (at (estimate, 0, 0)[0])); // no depth
  EXPECT_TRUE (std::isnan (at (estimate, 4, 4)[0])); // no flow
  EXPECT_NEAR (at (estimate, 2, 15)[2], 0.0, 1e-6);  // out of view: z as it was
}

TEST (Lifting, RigidMotionMovesPointsAndTheirPictures)
{
  Estimate estimate;
  RigidPose pose;
  pose.parameters = {0, 0, 0, 0.2, 0, 2.0};
  moveRigidly (walls(), pose, estimate);
  // (-0.1, -0.1, 2) goes to (0.1, -0.1, 4): from pixel 3 to 3.75, from 2 to 2.25.
  EXPECT_NEAR (estimate.flow.at<cv::Vec2f> (2, 3)[0], 0.75, 1e-6);
  EXPECT_NEAR (estimate.flow.at<cv::Vec2f> (2, 3)[1], 0.25, 1e-6);
  EXPECT_NEAR (at (estimate, 2, 3)[2], 2.0, 1e-6);
  EXPECT_TRUE (std::isnan (estimate.flow.at<cv::Vec2f> (0, 0)[0]));
  pose.parameters[5] = -3.0; // behind the camera: moved, but not seen
  moveRigidly (walls(), pose, estimate);
  EXPECT_TRUE (std::isnan (estimate.flow.at<cv::Vec2f> (2, 3)[0]));
  EXPECT_NEAR (at (estimate, 2, 3)[2], -3.0, 1e-6);
}

TEST (PairScores, TruthResidualsAndUnknownsByHand)
{
  PairData pair = walls();
  pair.truth.flow = cv::Mat (12, 16, CV_32FC2, cv::Scalar (3.0, 4.0));
  pair.truth.visible = cv::Mat (12, 16, CV_8UC1, cv::Scalar (255));
  pair.truth.visible.row (5) = 0;
  const Estimate rest = makeMethod ("zero", 1)->run (pair);
  const Score score = PairScorer (pair).score (rest, {});
  EXPECT_EQ (score.points, 191.0);
  EXPECT_NEAR (score.epe_visible, 5.0, 1e-6);
  EXPECT_NEAR (score.epe_occluded, 5.0, 1e-6);
  EXPECT_DOUBLE_EQ (score.out_visible, 1.0);
  EXPECT_DOUBLE_EQ (score.photo_mean, 10.0);
  EXPECT_NEAR (score.depth_mean, 0.2, 1e-6);
  EXPECT_TRUE (std::isnan (score.epe3d_all)); // no true scene flow
  EXPECT_TRUE (std::isnan (score.ari));
  EXPECT_TRUE (std::isnan (score.seen)); // reports no visibility
}

TEST (PairScores, LiftedFlowHasNoDepthResidual)
{
  const PairData pair = walls();
  Estimate estimate;
  estimate.flow = cv::Mat (12, 16, CV_32FC2, cv::Scalar (0.0, 0.0));
  liftByDepth (pair, estimate);
  EXPECT_TRUE (std::isnan (PairScorer (pair).score (estimate, {}).depth_mean));
}

TEST (Generated, NamesTruthAndCamera)
{
  GeneratedOptions options;
  options.scenes = {SceneKind::StaticRoom, SceneKind::MultiBody};
  options.motions = {MotionSize::Easy};
  options.width = 48;
  options.height = 36;
  options.frames = 3;
  const auto all = openGenerated (options);
  ASSERT_EQ (all.size(), 4u);
  EXPECT_EQ (all[0]->name(), "static_room_easy_none");
  EXPECT_EQ (all[3]->name(), "multi_body_easy_kinect");
  const io::MotionTruth rigid = all[0]->truth (0, 2);
  ASSERT_TRUE (rigid.rigid.has_value());
  const RigidPose camera = all[0]->cameraPose (2)->inverse() * *all[0]->cameraPose (0);
  EXPECT_THAT (*rigid.rigid, test::isNear (camera, 1e-9, 1e-9));
  const io::MotionTruth bodies = all[1]->truth (0, 1);
  EXPECT_FALSE (bodies.rigid.has_value());
  EXPECT_GT (bodies.bodies.size(), 2u);
  EXPECT_FALSE (all[1]->truth (1, 2).flow.empty());
  EXPECT_TRUE (all[1]->truth (1, 2).labels.empty());
  EXPECT_TRUE (all[1]->truth (2, 1).flow.empty());
}

TEST (Work, MethodsThatCannotRunHaveUnknownRows)
{
  class DepthOnly : public io::RgbdSequence {
  public:
    std::string
    name () const override
    {
      return "walls";
    }
    int
    frames () const override
    {
      return 2;
    }
    io::RgbdImages
    frame (int k) const override
    {
      const PairData pair = walls();
      io::RgbdImages images = k == 0 ? pair.reference : pair.current;
      images.color.release();
      return images;
    }
  };
  EvaluateOptions options;
  options.dataset = "cases";
  options.methods = {"zero", "dis_fast", "msf:labels=true", "msf:start=true"};
  const auto rows =
      PairRunner (options).run ({4, std::make_shared<DepthOnly>(), "walls", 0, 1});
  ASSERT_EQ (rows.size(), 4u);
  EXPECT_EQ (rows[1].pair, 4u);
  EXPECT_NEAR (rows[0].score.depth_mean, 0.2, 1e-6);
  for (int i = 1; i < 4; ++i)
    EXPECT_TRUE (std::isnan (rows[i].score.sec)) << options.methods[i];
}

TEST (FlowBaselines, TakeImagesSmallerThanTwoPatches)
{
  const cv::Size sizes[] = {{12, 12}, {13, 40}, {40, 15}, {16, 16}};
  for (const cv::Size& size : sizes) {
    PairData pair;
    pair.reference = {cv::Mat (size, CV_8UC3, cv::Scalar::all (90)),
                      cv::Mat (size, CV_32FC1, 2.0),
                      {10.0, 10.0, 3.5, 2.5}};
    pair.current = pair.reference;
    for (const char* name : {"dis_fast", "dis_medium"}) {
      const Estimate estimate = makeMethod (name, 1)->run (pair);
      ASSERT_EQ (estimate.flow.size(), size) << name;
      EXPECT_LT (cv::norm (estimate.flow, cv::NORM_INF), 0.1) << name << " " << size;
    }
  }
}

} // namespace
