// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/result_scenes.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::visualization;

const float kNan = std::numeric_limits<float>::quiet_NaN();
const cv::Size kSize (40, 20);

/** A wall at 2 m; its right half moves by (0.1, 0, 0), the last column is unknown. */
ResultClouds
someResult ()
{
  ResultClouds result;
  SceneFlow& flow = result.scene_flow;
  flow.camera = {100.0, 100.0, 20.0, 10.0};
  flow.points.create (kSize, CV_32FC3);
  flow.displacement = cv::Mat (kSize, CV_32FC3, cv::Scalar::all (0));
  flow.displacement.colRange (20, 40).setTo (cv::Scalar (0.1, 0, 0));
  flow.displacement.col (39).setTo (cv::Scalar::all (kNan));
  flow.flow = cv::Mat (kSize, CV_32FC2, cv::Scalar::all (0));
  flow.labels = cv::Mat (kSize, CV_32SC1, cv::Scalar (0));
  flow.labels.colRange (20, 40).setTo (1);
  flow.visibility =
      cv::Mat (kSize, CV_8UC1, cv::Scalar (pixelValue (Visibility::Visible)));
  flow.visibility.colRange (20, 30).setTo (pixelValue (Visibility::Occluded));
  for (int row = 0; row < kSize.height; ++row)
    for (int col = 0; col < kSize.width; ++col)
      flow.points.at<cv::Vec3f> (row, col) = {
          0.02F * (col - 20.0F), 0.02F * (row - 10.0F), 2.0F};
  flow.segments.resize (2);
  for (int i = 0; i < 2; ++i) {
    flow.segments[i].status = MotionStatus::Determined;
    flow.segments[i].points = i == 0 ? 300 : 100;
    flow.segments[i].group = i;
  }
  flow.groups = 2;
  flow.dominant_group = 0;
  result.reference_color = cv::Mat (kSize, CV_8UC3, cv::Scalar::all (100));
  result.current_color = cv::Mat (kSize, CV_8UC3, cv::Scalar::all (110));
  result.current_points = flow.points + cv::Scalar (0, 0, 0.05);
  return result;
}

TEST (ResultScenes, NamesAreThoseOfAllKinds)
{
  EXPECT_EQ (pictureKinds().size(), 12U);
  EXPECT_EQ (toString (PictureKind::AfterTints), "after_tints");
}

TEST (ResultScenes, OverlaysHoldBothCloudsWarpedOrNot)
{
  const ResultClouds result = someResult();
  const Scene before = resultScene (PictureKind::BeforeTints, result);
  const Scene after = resultScene (PictureKind::AfterTints, result);
  ASSERT_EQ (before.points.size(), 2U);
  EXPECT_TRUE (before.blended);
  EXPECT_FLOAT_EQ (before.points[0].positions.at<cv::Vec3f> (5, 25)[0], 0.1F);
  EXPECT_FLOAT_EQ (after.points[0].positions.at<cv::Vec3f> (5, 25)[0], 0.2F);
  EXPECT_TRUE (std::isnan (after.points[0].positions.at<cv::Vec3f> (5, 39)[0]));
  EXPECT_FLOAT_EQ (after.points[1].positions.at<cv::Vec3f> (5, 25)[2], 2.05F);
  ASSERT_EQ (after.legend.size(), 2U);
  EXPECT_EQ (after.legend[0].text, "warped reference");
  const cv::Vec3b tint = after.points[0].colors.at<cv::Vec3b> (5, 5);
  const cv::Vec3b other = after.points[1].colors.at<cv::Vec3b> (5, 5);
  EXPECT_GT (tint[2], tint[0]) << "warm";
  EXPECT_GT (other[0], other[2]) << "cold";
}

TEST (ResultScenes, WhatIsMissingIsNamed)
{
  ResultClouds result = someResult();
  result.current_points.release();
  EXPECT_THROW (resultScene (PictureKind::After, result), InvalidInput);
  EXPECT_NO_THROW (resultScene (PictureKind::Warped, result));
  result.current_color.release();
  EXPECT_THROW (resultScene (PictureKind::Residual, result), InvalidInput);
  EXPECT_THROW (resultScene (PictureKind::DepthResidual, result), InvalidInput);
  result.scene_flow.segments.clear();
  EXPECT_THROW (resultScene (PictureKind::Motions, result), InvalidInput);
  result.scene_flow.visibility.release();
  EXPECT_THROW (resultScene (PictureKind::Occlusion, result), InvalidInput);
  EXPECT_THROW (resultScene (PictureKind::Warped, ResultClouds()), InvalidInput);
}

TEST (ResultScenes, SegmentsAndMotionsHaveColoursOfTheirOwn)
{
  const Scene segments = resultScene (PictureKind::Segments, someResult());
  EXPECT_EQ (segments.title, "2 segments");
  const cv::Mat& colors = segments.points[0].colors;
  EXPECT_EQ (colors.at<cv::Vec3b> (3, 3), colors.at<cv::Vec3b> (9, 9));
  EXPECT_NE (colors.at<cv::Vec3b> (3, 3), colors.at<cv::Vec3b> (3, 30));
  const Scene motions = resultScene (PictureKind::Motions, someResult());
  ASSERT_EQ (motions.legend.size(), 2U);
  EXPECT_EQ (motions.legend[0].text, "largest, 75.0 %");
  EXPECT_EQ (motions.legend[1].text, "25.0 %");
  const cv::Vec3b largest = motions.points[0].colors.at<cv::Vec3b> (3, 3);
  EXPECT_EQ (largest[0], largest[2]) << "grey";
}

TEST (ResultScenes, OcclusionCountsItsKinds)
{
  const Scene scene = resultScene (PictureKind::Occlusion, someResult());
  ASSERT_EQ (scene.legend.size(), 2U) << "only what there is";
  EXPECT_EQ (scene.legend[0].text, "seen in both, 75.0 %");
  EXPECT_EQ (scene.legend[1].text, "occluded, 25.0 %");
}

TEST (ResultScenes, ArrowsStandOnAGridAndSkipWhatRests)
{
  SceneOptions options;
  options.arrow_step = 10;
  options.arrow_scale = 1.0;
  const Scene scene = resultScene (PictureKind::Arrows, someResult(), options);
  ASSERT_EQ (scene.arrows.size(), 4U) << "columns 25 and 35, rows 5 and 15";
  EXPECT_FLOAT_EQ (scene.arrows[0].to[0] - scene.arrows[0].from[0], 0.1F);
  ASSERT_TRUE (scene.scale);
  EXPECT_NEAR (scene.scale->maximum, 0.1, 1e-6);
  EXPECT_EQ (scene.scale->title, "length of displacement [m]");
  options.arrow_scale = 3.0;
  const Scene enlarged = resultScene (PictureKind::Arrows, someResult(), options);
  EXPECT_FLOAT_EQ (enlarged.arrows[0].to[0] - enlarged.arrows[0].from[0], 0.3F);
  EXPECT_THAT (enlarged.title, ::testing::HasSubstr ("3 times"));
  // 0.1 m are 5 px at 2 m: 1.6 steps of 20 px take 5 times as much, by round numbers.
  options.arrow_step = 20;
  options.arrow_scale = 0.0;
  EXPECT_THAT (resultScene (PictureKind::Arrows, someResult(), options).title,
               ::testing::HasSubstr ("5 times"));
  options.arrow_step = -1;
  EXPECT_THROW (resultScene (PictureKind::Arrows, someResult(), options), InvalidInput);
}

TEST (ResultScenes, TrajectoriesEndWhereNothingIsKnown)
{
  const ResultClouds result = someResult();
  const cv::Mat first = result.scene_flow.displacement;
  cv::Mat second = 2.0 * first;
  second.colRange (30, 40).setTo (cv::Scalar::all (kNan));
  SceneOptions options;
  options.arrow_step = 10;
  options.arrow_scale = 1.0;
  const Scene scene = trajectoryScene (result, {first, second}, options);
  ASSERT_EQ (scene.lines.size(), 4U) << "columns 5 and 15 rest";
  EXPECT_EQ (scene.lines[0].points.size(), 3U) << "column 25";
  EXPECT_FLOAT_EQ (scene.lines[0].points[2][0], 0.1F + 0.2F);
  EXPECT_EQ (scene.lines[1].points.size(), 2U) << "column 35";
  EXPECT_NE (scene.lines[0].colors[0], scene.lines[0].colors[2]);
  EXPECT_THROW (trajectoryScene (result, {}, options), InvalidInput);
  EXPECT_THROW (trajectoryScene (result, {cv::Mat (2, 2, CV_32FC3)}, options),
                InvalidInput);
}

TEST (ResultScenes, ResidualsAreMeasuredWhereBothFramesSee)
{
  SceneOptions options;
  options.maximum = 100.0;
  const Scene depth = resultScene (PictureKind::DepthResidual, someResult(), options);
  ASSERT_TRUE (depth.scale);
  EXPECT_EQ (depth.scale->title, "residual [mm]");
  const cv::Mat& colors = depth.points[0].colors;
  const cv::Vec3b hidden = colors.at<cv::Vec3b> (5, 25);
  EXPECT_EQ (hidden, cv::Vec3b (150, 150, 150));
  EXPECT_NE (colors.at<cv::Vec3b> (5, 5), hidden) << "50 of 100 mm";
  // With the end at 50 mm, the same residual is the map's last colour.
  options.maximum = 50.0;
  const Scene full = resultScene (PictureKind::DepthResidual, someResult(), options);
  EXPECT_NE (full.points[0].colors.at<cv::Vec3b> (5, 5), colors.at<cv::Vec3b> (5, 5));
  const Scene brightness = resultScene (PictureKind::Residual, someResult(), {});
  EXPECT_NEAR (brightness.scale->maximum, 10.0, 1e-6);
}

TEST (ResultScenes, ScalesEndAtRoundNumbersAndTellWhatLiesBeyond)
{
  ResultClouds result = someResult();
  result.current_color.colRange (0, 10).setTo (cv::Scalar::all (113));
  const Scene automatic = resultScene (PictureKind::Residual, result);
  EXPECT_DOUBLE_EQ (automatic.scale->maximum, 15.0) << "10 and 13 grey levels";
  EXPECT_FALSE (automatic.scale->open);
  result.current_color.at<cv::Vec3b> (3, 3) = {200, 200, 200};
  const Scene outlier = resultScene (PictureKind::Residual, result);
  EXPECT_DOUBLE_EQ (outlier.scale->maximum, 15.0);
  EXPECT_TRUE (outlier.scale->open);
  SceneOptions options;
  options.maximum = 7.0;
  const Scene given = resultScene (PictureKind::Residual, result, options);
  EXPECT_DOUBLE_EQ (given.scale->maximum, 7.0) << "not rounded";
  EXPECT_TRUE (given.scale->open);
}

TEST (ResultScenes, CracksOfWarpedCloudsAreClosed)
{
  EXPECT_FALSE (
      resultScene (PictureKind::Warped, someResult()).points[0].triangles.empty());
  EXPECT_TRUE (
      resultScene (PictureKind::Before, someResult()).points[0].triangles.empty());
}

TEST (ResultScenes, CloudsWithoutColoursAreLit)
{
  ResultClouds result = someResult();
  result.reference_color.release();
  result.current_color.release();
  for (int row = 0; row < kSize.height; ++row) // the left half is steep
    for (int col = 0; col < 20; ++col)
      result.scene_flow.points.at<cv::Vec3f> (row, col)[2] += 0.08F * (20 - col);
  const Scene scene = resultScene (PictureKind::Warped, result);
  const cv::Vec3b steep = scene.points[0].colors.at<cv::Vec3b> (10, 5);
  const cv::Vec3b frontal = scene.points[0].colors.at<cv::Vec3b> (10, 30);
  EXPECT_GT (frontal[0], steep[0] + 50);
  EXPECT_LT (frontal[0], 230) << "stands out on white paper";
  EXPECT_NO_THROW (resultScene (PictureKind::AfterTints, result));
  EXPECT_NO_THROW (resultScene (PictureKind::Segments, result));
}

TEST (ResultScenes, WarpGoesThroughTheWindow)
{
  const ResultClouds result = someResult();
  const cv::Mat first = result.scene_flow.displacement;
  const cv::Mat second = 3.0 * first;
  const auto at = [&] (double t) {
    const Scene scene = warpScene (result, {first, second}, t);
    return scene.points.back().positions.at<cv::Vec3f> (5, 25)[0] - 0.1F;
  };
  EXPECT_NEAR (at (0.0), 0.0, 1e-6);
  EXPECT_NEAR (at (0.5), 0.05, 1e-6);
  EXPECT_NEAR (at (1.0), 0.1, 1e-6);
  EXPECT_NEAR (at (1.5), 0.2, 1e-6);
  EXPECT_NEAR (at (2.0), 0.3, 1e-6);
  EXPECT_NEAR (at (9.0), 0.3, 1e-6) << "stays at the last frame";
}

} // namespace
