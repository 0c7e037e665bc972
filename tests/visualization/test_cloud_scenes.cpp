// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/box_chain.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/cloud_scenes.h>

#include <cmath>
#include <set>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::visualization;
using pcl_msf::testing::BoxChain;
using pcl_msf::testing::ChainCloud;
using pcl_msf::testing::drawChain;

/** A chain, its parts the boxes, one point unknown. */
CloudResult
chainResult ()
{
  const BoxChain chain;
  const ChainCloud source = drawChain (chain, 3000, false, 1);
  CloudResult result;
  result.source = source.points;
  result.part = source.box;
  for (std::size_t i = 0; i < source.rest.size(); ++i)
    result.warped.push_back (
        (chain.pose (source.box[i]) * source.rest[i].cast<double>()).cast<float>());
  result.target = drawChain (chain, 3000, true, 2).points;
  result.source[7].setConstant (NAN);
  result.warped[7].setConstant (NAN);
  result.part[7] = -1;
  CloudJoint joint;
  joint.parent = 0;
  joint.child = 1;
  joint.axis = BoxChain::axis (1);
  joint.point = chain.seam (1);
  joint.angle = chain.angle;
  result.joints = {joint};
  return result;
}

TEST (CloudScenes, BeforeAndAfterShowBothClouds)
{
  const CloudResult result = chainResult();
  for (const PictureKind kind : {PictureKind::BeforeTints, PictureKind::AfterTints}) {
    const Scene scene = cloudScene (kind, result);
    ASSERT_EQ (scene.points.size(), 2u);
    EXPECT_TRUE (scene.blended);
    EXPECT_EQ (scene.points[0].positions.total(), 2999u) << "known points alone";
    EXPECT_EQ (scene.points[1].positions.total(), 3000u);
    const auto& first =
        kind == PictureKind::BeforeTints ? result.source : result.warped;
    EXPECT_EQ (scene.points[0].positions.at<cv::Vec3f> (0)[0], first[0].x());
  }
}

TEST (CloudScenes, PartsHaveColoursAndJointsAxes)
{
  const CloudResult result = chainResult();
  const Scene scene = cloudScene (PictureKind::Motions, result);
  ASSERT_EQ (scene.points.size(), 1u);
  EXPECT_EQ (scene.title, "3 parts, 1 joints");
  ASSERT_EQ (scene.legend.size(), 1u);
  EXPECT_EQ (scene.legend[0].text, "part 1 on 0: 11.5 deg");
  ASSERT_FALSE (scene.lines.empty());
  for (const Polyline& line : scene.lines) {
    const cv::Vec3f d = line.points[1] - line.points[0];
    const Eigen::Vector3d along (d[0], d[1], d[2]);
    EXPECT_GT (along.norm(), 0.3) << "it sticks out of the body";
    EXPECT_NEAR (along.normalized().dot (result.joints[0].axis), 1.0, 1e-4);
    const cv::Vec3f m = 0.5F * (line.points[1] + line.points[0]);
    EXPECT_LT ((Eigen::Vector3d (m[0], m[1], m[2]) - result.joints[0].point).norm(),
               0.02);
  }
}

TEST (CloudScenes, LightTellsFacesApart)
{
  CloudResult result = chainResult();
  const Scene scene = cloudScene (PictureKind::Warped, result);
  std::set<int> reds; // of the brightest channel, in steps
  for (const auto& color : cv::Mat_<cv::Vec3b> (scene.points[0].colors))
    reds.insert (color[2] / 32);
  EXPECT_GE (reds.size(), 3u);
}

TEST (CloudScenes, SpacingFollowsDensity)
{
  const BoxChain chain;
  const double thin = cloudSpacing (drawChain (chain, 2000, false, 3).points);
  const double dense = cloudSpacing (drawChain (chain, 32000, false, 4).points);
  EXPECT_NEAR (thin / dense, 4.0, 1.2);
}

TEST (CloudScenes, SayWhatTheyLack)
{
  CloudResult result = chainResult();
  EXPECT_THROW (cloudScene (PictureKind::Occlusion, result), InvalidInput);
  result.target.clear();
  EXPECT_THROW (cloudScene (PictureKind::BeforeTints, result), InvalidInput);
  EXPECT_NO_THROW (cloudScene (PictureKind::Motions, result));
  result.part.pop_back();
  EXPECT_THROW (cloudScene (PictureKind::Motions, result), InvalidInput);
  EXPECT_THROW (cloudScene (PictureKind::Motions, {}), InvalidInput);
}

} // namespace
