// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Behind PCL's filters.
#include <pcl/filters/fast_bilateral.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>

#include <gtest/gtest.h>

#include "support/chain_clouds.h"
#include "support/rigid_pair.h"
#include <pcl_msf/piecewise_rigid_registration.h>

#include <random>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;
using Color = pcl::PointXYZRGB;
using ColorCloud = pcl::PointCloud<Color>;

class BehindFilters : public ::testing::Test {
protected:
  /** What a filter leaves of a cloud. */
  template <typename PointT>
  static typename pcl::PointCloud<PointT>::Ptr
  filtered (pcl::Filter<PointT>& filter,
            const typename pcl::PointCloud<PointT>::ConstPtr& cloud)
  {
    auto result = pcl::make_shared<pcl::PointCloud<PointT>>();
    filter.setInputCloud (cloud);
    filter.filter (*result);
    return result;
  }
  /** Mean error of the chain, after a filter on both clouds. */
  double
  errorBehind (pcl::Filter<Point>& filter)
  {
    const Cloud::Ptr source = filtered (filter, source_);
    PiecewiseRigidRegistration<Point> registration;
    registration.setInputSource (source);
    registration.setInputTarget (filtered (filter, target_));
    Cloud warped;
    registration.align (warped);
    EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
    EXPECT_EQ (warped.size(), source->size());
    EXPECT_EQ (registration.getSceneFlow().groups, chain_.boxes);
    return meanChainError (chain_, *source, warped);
  }
  /** Error of the motion of the camera's pair, metres, after a filter on both clouds.
   */
  template <typename Filter>
  static double
  motionErrorBehind (const Filter& apply)
  {
    PiecewiseRigidRegistration<Color> registration;
    registration.setInputSource (apply (RigidPair::reference()));
    registration.setInputTarget (apply (RigidPair::current()));
    ColorCloud warped;
    registration.align (warped);
    EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
    const Eigen::Vector3d middle (0.0, 0.0, 2.0);
    return (RigidPose::fromMatrix (registration.getFinalTransformation()) * middle -
            RigidPair::motion() * middle)
        .norm();
  }

  static BoxChain
  chain ()
  {
    BoxChain result;
    result.angle = 0.1; // little enough that joints open no walls
    return result;
  }

  const BoxChain chain_ = chain();
  Cloud::Ptr source_ = cloudOf<Point> (drawChain (chain_, 20000, false, 41).points);
  Cloud::Ptr target_ = cloudOf<Point> (drawChain (chain_, 20000, true, 42).points);
};

TEST_F (BehindFilters, VoxelGrid)
{
  pcl::VoxelGrid<Point> filter;
  filter.setLeafSize (0.012F, 0.012F, 0.012F);
  EXPECT_LT (errorBehind (filter), 2.5e-3);
}

TEST_F (BehindFilters, StatisticalOutlierRemoval)
{
  std::mt19937 random (43);
  std::uniform_real_distribution<float> place (-0.6F, 1.6F);
  for (Cloud::Ptr& cloud : {std::ref (source_), std::ref (target_)})
    for (int i = 0; i < 1000; ++i)
      cloud->emplace_back (place (random), place (random), place (random));
  pcl::StatisticalOutlierRemoval<Point> filter;
  filter.setMeanK (20);
  filter.setStddevMulThresh (1.0);
  EXPECT_LT (errorBehind (filter), 2.5e-3);
}

TEST_F (BehindFilters, PassThroughWithAndWithoutItsGrid)
{
  pcl::PassThrough<Color> filter;
  filter.setFilterFieldName ("z");
  filter.setFilterLimits (0.0F, 2.4F);
  for (const bool organized : {true, false}) {
    filter.setKeepOrganized (organized);
    EXPECT_LT (motionErrorBehind (
                   [&] (const auto& cloud) { return filtered (filter, cloud); }),
               organized ? 2e-3 : 3e-2) // the grid tells more
        << organized;
  }
}

TEST_F (BehindFilters, PassThroughOfACloudWithoutAGrid)
{
  // What does not belong to the body is cut off; with setKeepOrganized it is NaN.
  std::mt19937 random (44);
  std::uniform_real_distribution<float> place (0.0F, 1.0F);
  for (const Cloud::Ptr& cloud : {source_, target_})
    for (int i = 0; i < 3000; ++i)
      cloud->emplace_back (-2.0F - place (random), place (random), 0.0F);
  pcl::PassThrough<Point> filter;
  filter.setFilterFieldName ("x");
  filter.setFilterLimits (-1.0F, 10.0F);
  for (const bool organized : {false, true}) {
    filter.setKeepOrganized (organized);
    EXPECT_LT (errorBehind (filter), 2.5e-3) << organized;
  }
}

TEST_F (BehindFilters, FastBilateralFilter)
{
  pcl::FastBilateralFilter<Color> filter;
  filter.setSigmaS (3.0F);
  filter.setSigmaR (0.05F);
  EXPECT_LT (
      motionErrorBehind ([&] (const auto& cloud) { return filtered (filter, cloud); }),
      3e-3);
}

} // namespace
