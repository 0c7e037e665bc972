// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// With segments of PCL's own, and results as PCL tells segments.
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <gtest/gtest.h>

#include "support/chain_clouds.h"
#include "support/rigid_pair.h"
#include <pcl_msf/motion_clusters.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <array>
#include <map>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;
using Labels = pcl::PointCloud<pcl::Label>;
using Clusters = std::vector<pcl::PointIndices>;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

template <typename PointT>
pcl::PointCloud<PointT>
align (PiecewiseRigidRegistration<PointT>& registration)
{
  pcl::PointCloud<PointT> warped;
  registration.align (warped);
  EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
  return warped;
}

TEST (PclSegmentations, EuclideanClustersMoveOnTheirOwn)
{
  BoxChain box; // two of them, apart
  box.boxes = 1;
  box.root = {};
  const std::array<RigidPose, 2> motions{RigidPose{{0.0, 0.1, 0.0, 0.02, 0.0, 0.03}},
                                         RigidPose{{0.1, 0.0, 0.0, 0.0, 0.06, 0.0}}};
  std::vector<Eigen::Vector3f> source;
  std::vector<Eigen::Vector3f> target;
  for (int b = 0; b < 2; ++b) {
    const Eigen::Vector3f place (0.0F, 0.8F * static_cast<float> (b), 0.0F);
    for (const auto& p : drawChain (box, 2000, false, 51 + b).points)
      source.push_back (p + place);
    for (const auto& p : drawChain (box, 2000, false, 53 + b).points)
      target.push_back ((motions[b] * (p + place).cast<double>()).cast<float>());
  }
  source.emplace_back (0.2F, 0.4F, 0.0F); // between them, in no cluster
  const Cloud::Ptr cloud = cloudOf<Point> (source);
  Clusters clusters;
  pcl::EuclideanClusterExtraction<Point> extraction;
  extraction.setClusterTolerance (0.06);
  extraction.setMinClusterSize (100);
  extraction.setSearchMethod (pcl::make_shared<pcl::search::KdTree<Point>>());
  extraction.setInputCloud (cloud);
  extraction.extract (clusters);
  ASSERT_EQ (clusters.size(), 2u);

  PiecewiseRigidRegistration<Point> registration;
  registration.setInputSource (cloud);
  registration.setInputTarget (cloudOf<Point> (target));
  registration.setSegmentation (clusters);
  const Cloud warped = align (registration);
  const SceneFlow& flow = registration.getSceneFlow();
  ASSERT_EQ (flow.segments.size(), 2u);
  EXPECT_TRUE (flow.pairs.empty()) << "they don't touch";
  EXPECT_TRUE (std::isnan (warped.back().x));
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector3d at = flow.segments[k].centroid;
    const RigidPose& truth = motions[at.y() > 0.4 ? 1 : 0];
    EXPECT_LT ((flow.segments[k].current_from_reference * at - truth * at).norm(),
               1e-3);
    for (const auto index : clusters[k].indices)
      ASSERT_EQ (flow.labels.at<int> (0, index), k);
  }
}

TEST (PclSegmentations, SupervoxelsAreJoinedToParts)
{
  using Color = pcl::PointXYZRGBA;
  const BoxChain chain;
  const auto source = cloudOf<Color> (drawChain (chain, 8000, false, 55).points);
  pcl::SupervoxelClustering<Color> clustering (0.02F, 0.1F);
  clustering.setUseSingleCameraTransform (false);
  clustering.setInputCloud (source);
  clustering.setColorImportance (0.0F);
  std::map<std::uint32_t, pcl::Supervoxel<Color>::Ptr> supervoxels;
  clustering.extract (supervoxels);
  ASSERT_GT (supervoxels.size(), 30u);
  const auto labels = pcl::make_shared<Labels> (source->size(), 1);
  const auto labelled = clustering.getLabeledCloud();
  ASSERT_EQ (labelled->size(), source->size());
  for (std::size_t i = 0; i < labels->size(); ++i)
    (*labels)[i].label = (*labelled)[i].label > 0 ? (*labelled)[i].label : kNone;

  PiecewiseRigidRegistration<Color> registration;
  registration.setInputSource (source);
  registration.setInputTarget (
      cloudOf<Color> (drawChain (chain, 8000, true, 56).points));
  registration.setSegmentation (labels);
  const auto warped = align (registration);
  const SceneFlow& flow = registration.getSceneFlow();
  EXPECT_LE (flow.segments.size(), supervoxels.size());
  EXPECT_GE (flow.groups, chain.boxes);
  EXPECT_LT (flow.groups, 4 * chain.boxes) << "some lie on two boxes";
  EXPECT_LT (meanChainError (chain, *source, warped), 6e-3);
  std::map<int, std::uint32_t> label_of;
  for (std::size_t i = 0; i < labels->size(); ++i) {
    const int k = flow.labels.at<int> (0, static_cast<int> (i));
    ASSERT_EQ (k < 0, (*labels)[i].label == kNone);
    if (k >= 0) {
      ASSERT_EQ (label_of.try_emplace (k, (*labels)[i].label).first->second,
                 (*labels)[i].label);
    }
  }
}

TEST (PclSegmentations, RegionsThatHaveGrownStayWhole)
{
  // The faces of a box, whose edges are in no region: they slide but for each other.
  BoxChain box;
  box.boxes = 1;
  const Cloud::Ptr source = cloudOf<Point> (drawChain (box, 5000, false, 57).points);
  const auto tree = pcl::make_shared<pcl::search::KdTree<Point>>();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationOMP<Point, pcl::Normal> estimation;
  estimation.setSearchMethod (tree);
  estimation.setInputCloud (source);
  estimation.setKSearch (15);
  estimation.compute (*normals);
  Clusters regions;
  pcl::RegionGrowing<Point, pcl::Normal> growing;
  growing.setMinClusterSize (100);
  growing.setSearchMethod (tree);
  growing.setNumberOfNeighbours (20);
  growing.setInputCloud (source);
  growing.setInputNormals (normals);
  growing.setSmoothnessThreshold (0.08F);
  growing.setCurvatureThreshold (0.05F);
  growing.extract (regions);
  ASSERT_EQ (regions.size(), 6u);

  PiecewiseRigidRegistration<Point> registration;
  registration.setInputSource (source);
  registration.setInputTarget (cloudOf<Point> (drawChain (box, 5000, true, 58).points));
  registration.setSegmentation (regions);
  const Cloud warped = align (registration);
  const SceneFlow& flow = registration.getSceneFlow();
  ASSERT_EQ (flow.segments.size(), regions.size());
  EXPECT_GE (flow.pairs.size(), 8u);
  EXPECT_EQ (flow.groups, 1);
  EXPECT_LT (meanChainError (box, *source, warped), 1e-3);
  for (std::size_t k = 0; k < regions.size(); ++k)
    for (const auto i : regions[k].indices)
      ASSERT_EQ (flow.labels.at<int> (0, i), static_cast<int> (k));
}

TEST (PclSegmentations, PlanesOfAnOrganizedCloud)
{
  using Color = pcl::PointXYZRGB;
  const auto source = RigidPair::reference();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::IntegralImageNormalEstimation<Color, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setInputCloud (source);
  estimation.compute (*normals);
  pcl::OrganizedMultiPlaneSegmentation<Color, pcl::Normal, pcl::Label> planes;
  planes.setMinInliers (500);
  planes.setInputCloud (source);
  planes.setInputNormals (normals);
  std::vector<pcl::ModelCoefficients> models;
  Clusters inliers;
  planes.segment (models, inliers);
  ASSERT_FALSE (inliers.empty());

  PiecewiseRigidRegistration<Color> registration;
  registration.setInputSource (source);
  registration.setInputTarget (RigidPair::current());
  registration.setSegmentation (inliers);
  registration.setSourceNormals (normals);
  align (registration);
  EXPECT_EQ (registration.getSceneFlow().segments.size(), inliers.size());
}

TEST (PclSegmentations, MotionsAreToldAsClustersLabelsAndCorrespondences)
{
  BoxChain chain;
  chain.boxes = 2;
  const ChainCloud drawn = drawChain (chain, 4000, false, 59);
  const Cloud::Ptr source = cloudOf<Point> (drawn.points);
  source->push_back (Point (NAN, NAN, NAN));
  const Cloud::Ptr target = cloudOf<Point> (drawChain (chain, 4000, true, 60).points);
  PiecewiseRigidRegistration<Point> registration;
  registration.setInputSource (source);
  registration.setInputTarget (target);
  const Cloud warped = align (registration);
  const SceneFlow& flow = registration.getSceneFlow();
  const Clusters clusters = motionClusters (flow);
  const Labels labels = motionLabels (flow);
  ASSERT_EQ (clusters.size(), 2u);
  ASSERT_EQ (labels.size(), source->size());
  EXPECT_EQ (labels.back().label, kNone);
  EXPECT_GE (clusters[0].indices.size(), clusters[1].indices.size());
  EXPECT_EQ (clusters[0].indices.size() + clusters[1].indices.size(), 4000u);
  int right = 0;
  const int first = drawn.box[clusters[0].indices[0]];
  for (int g = 0; g < 2; ++g)
    for (const auto i : clusters[g].indices) {
      ASSERT_EQ (labels[i].label, static_cast<std::uint32_t> (g));
      right += drawn.box[i] == (g == 0 ? first : 1 - first);
    }
  EXPECT_GT (right, 3800);
  ASSERT_GT (registration.getCorrespondences().size(), 3500u);
  for (const pcl::Correspondence& pair : registration.getCorrespondences())
    ASSERT_NEAR (pair.distance,
                 (warped[pair.index_query].getVector3fMap() -
                  (*target)[pair.index_match].getVector3fMap())
                     .squaredNorm(),
                 1e-6);
  // And what they are can be given again.
  registration.setSegmentation (clusters);
  align (registration);
  EXPECT_EQ (registration.getSceneFlow().segments.size(), 2u);
}

} // namespace
