// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/point_files.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::testing;

BodyOptions
options (BodyKind body)
{
  BodyOptions o;
  o.body = body;
  o.points = 2000;
  o.angle = 30.0;
  return o;
}

TEST (BodyClouds, LinksHangOnTheirJoints)
{
  for (const BodyKind body : allBodies()) {
    const BodyClouds clouds = synthesizeBody (options (body));
    EXPECT_EQ (clouds.joints.size() + 1, clouds.poses.size());
    for (const BodyJoint& joint : clouds.joints) {
      const RigidPose turn =
          clouds.poses[joint.parent].inverse() * clouds.poses[joint.child];
      EXPECT_NEAR ((turn * joint.point - joint.point).norm(), 0.0, 1e-9);
      EXPECT_NEAR (turn.angle(), std::abs (joint.angle), 1e-9);
      EXPECT_NEAR ((turn.rotation() * joint.axis - joint.axis).norm(), 0.0, 1e-9);
      EXPECT_GE (std::abs (joint.angle), 15.0 * M_PI / 180.0 - 1e-9);
    }
    const auto most = std::max_element (clouds.link.begin(), clouds.link.end());
    EXPECT_EQ (static_cast<std::size_t> (*most) + 1, clouds.poses.size());
  }
}

TEST (BodyClouds, TheTruthLiesOnTheTarget)
{
  for (const BodyKind body : allBodies()) {
    const BodyClouds clouds = synthesizeBody (options (body));
    ASSERT_EQ (clouds.truth.size(), clouds.source.size());
    int far = 0; // inside another link as that has turned
    for (std::size_t i = 0; i < clouds.truth.size(); i += 10) {
      const Eigen::Vector3d moved =
          clouds.poses[clouds.link[i]] * clouds.source[i].cast<double>();
      EXPECT_NEAR ((clouds.truth[i].cast<double>() - moved).norm(), 0.0, 1e-6);
      float nearest = 1.0F;
      for (const auto& q : clouds.target)
        nearest = std::min (nearest, (q - clouds.truth[i]).norm());
      far += nearest > 0.08F;
    }
    EXPECT_LT (far, 20) << toString (body);
  }
}

TEST (BodyClouds, ACutTakesPointsAndTheirTruth)
{
  BodyOptions o = options (BodyKind::Animal);
  o.cut = 0.25;
  const BodyClouds clouds = synthesizeBody (o);
  EXPECT_NEAR (static_cast<double> (clouds.target.size()), 1500.0, 5.0);
  const auto unknown = std::count_if (clouds.truth.begin(),
                                      clouds.truth.end(),
                                      [] (const auto& p) { return !p.allFinite(); });
  EXPECT_NEAR (static_cast<double> (unknown), 500.0, 100.0);
  o.outliers = 0.2;
  EXPECT_EQ (synthesizeBody (o).target.size(), clouds.target.size() + 400);
}

TEST (BodyClouds, SeedAndNoiseDoWhatTheySay)
{
  BodyOptions o = options (BodyKind::Hand);
  const BodyClouds once = synthesizeBody (o);
  EXPECT_EQ (synthesizeBody (o).target, once.target);
  o.seed = 2;
  EXPECT_NE (synthesizeBody (o).target, once.target);
  o.seed = 1;
  o.noise = 1e-3;
  const BodyClouds noisy = synthesizeBody (o);
  ASSERT_EQ (noisy.poses.size(), once.poses.size());
  EXPECT_EQ (noisy.poses[3].parameters, once.poses[3].parameters);
  EXPECT_NE (noisy.source, once.source);
}

TEST (BodyClouds, SaysWhatItCannotDraw)
{
  const auto why = [] (BodyOptions o) {
    std::string text;
    EXPECT_FALSE (o.isValid (&text));
    EXPECT_THROW (synthesizeBody (o), InvalidInput);
    return text;
  };
  BodyOptions o;
  o.points = 3;
  EXPECT_EQ (why (o), "points: must be in [100, 1e+07]");
  o = {};
  o.cut = 1.0;
  EXPECT_EQ (why (o), "cut: must be in [0, 0.9]");
  o = {};
  o.noise = NAN;
  EXPECT_EQ (why (o), "noise: must be in [0, 1]");
}

TEST (BodyClouds, FilesHoldThem)
{
  const BodyClouds clouds = synthesizeBody (options (BodyKind::Chain));
  const TemporaryFolder folder;
  writeBody (clouds, folder ("."));
  EXPECT_EQ (io::readPoints (folder ("source.ply")).points, clouds.source);
  EXPECT_EQ (io::readPoints (folder ("target.ply")).points, clouds.target);
  EXPECT_EQ (io::readPoints (folder ("truth.ply")).points, clouds.truth);
  std::istringstream joints (readFile (folder ("joints.txt")));
  std::vector<double> numbers;
  for (double number; joints >> number;)
    numbers.push_back (number);
  ASSERT_EQ (numbers.size(), 9 * clouds.joints.size());
  EXPECT_EQ (numbers[9], 2.0);
  EXPECT_EQ (numbers[10], 1.0);
  EXPECT_NEAR (numbers[14], clouds.joints[1].angle * 180.0 / M_PI, 1e-6);
  const std::string poses = readFile (folder ("poses.txt"));
  EXPECT_EQ (std::count (poses.begin(), poses.end(), '\n'), 4);
}

TEST (BodySequences, GoOnMovingAsTheyBegan)
{
  for (const BodyKind body : allBodies()) {
    const std::vector<BodyClouds> sequence = synthesizeBodySequence (options (body), 3);
    ASSERT_EQ (sequence.size(), 3u);
    const BodyClouds first = synthesizeBody (options (body));
    EXPECT_EQ (sequence[0].source, first.source);
    EXPECT_EQ (sequence[0].target, first.target);
    EXPECT_EQ (sequence[0].truth, first.truth);
    for (int k = 1; k <= 3; ++k) {
      const BodyClouds& clouds = sequence[k - 1];
      EXPECT_EQ (clouds.source, first.source);
      EXPECT_EQ (clouds.link, first.link);
      EXPECT_NEAR (clouds.poses[0].angle(), k * 5.0 * M_PI / 180.0, 1e-9);
      for (std::size_t j = 0; j < clouds.joints.size(); ++j) {
        const BodyJoint& joint = clouds.joints[j];
        EXPECT_NEAR (joint.angle, k * first.joints[j].angle, 1e-12);
        const RigidPose turn =
            clouds.poses[joint.parent].inverse() * clouds.poses[joint.child];
        EXPECT_NEAR ((turn * joint.point - joint.point).norm(), 0.0, 1e-9);
      }
      for (std::size_t i = 0; i < clouds.source.size(); i += 50)
        EXPECT_NEAR ((clouds.poses[clouds.link[i]] * clouds.source[i].cast<double>() -
                      clouds.truth[i].cast<double>())
                         .norm(),
                     0.0,
                     1e-6);
    }
  }
  EXPECT_THROW (synthesizeBodySequence (options (BodyKind::Chain), 0), InvalidInput);
}

} // namespace
