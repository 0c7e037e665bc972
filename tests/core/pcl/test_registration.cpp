// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <numeric>

namespace {

using namespace pcl_msf;

using Point = pcl::PointXYZRGB;
using Cloud = pcl::PointCloud<Point>;
using Registration = PiecewiseRigidRegistration<Point>;
using BaseRegistration = pcl::Registration<Point, Point>;

constexpr int kWidth = RigidPair::kWidth;
constexpr int kHeight = RigidPair::kHeight;

/** Largest distance, metres, between the truth and the 4x4 applied to the reference. */
double
largestError (const Eigen::Matrix4f& matrix, const Cloud& reference)
{
  const RigidPose pose = RigidPose::fromMatrix (matrix);
  double largest = 0.0;
  for (const Point& p : reference) {
    const Eigen::Vector3d x = p.getVector3fMap().cast<double>();
    largest = std::max (largest, (pose * x - RigidPair::motion() * x).norm());
  }
  return largest;
}

class RegistrationTest : public testing::Test {
protected:
  void
  SetUp () override
  {
    registration_->setInputSource (reference_);
    registration_->setInputTarget (current_);
  }

  Cloud::Ptr reference_ = RigidPair::reference();
  Cloud::Ptr current_ = RigidPair::current();
  Registration::Ptr registration_ = pcl::make_shared<Registration>();
  Cloud warped_;
};

TEST_F (RegistrationTest, WorksBehindTheBasePointer)
{
  const BaseRegistration::Ptr base = registration_;
  base->align (warped_);
  EXPECT_TRUE (base->hasConverged());
  EXPECT_EQ (warped_.width, reference_->width);
  EXPECT_EQ (warped_.height, reference_->height);
  EXPECT_LT (largestError (base->getFinalTransformation(), *reference_), 0.005);
  EXPECT_LT (base->getFitnessScore(), 1e-3);
  EXPECT_EQ (base->getClassName(), "PiecewiseRigidRegistration");
}

TEST_F (RegistrationTest, FinalTransformationIsTheDominantMotion)
{
  registration_->align (warped_);
  const SceneFlow& flow = registration_->getSceneFlow();
  EXPECT_TRUE (
      registration_->getFinalTransformation().isApprox (flow.dominant_motion.matrix()));
  EXPECT_TRUE (registration_->getLastIncrementalTransformation().isApprox (
      flow.dominant_motion.matrix()));
  EXPECT_GT (flow.report.iterations, 0);
  EXPECT_GT (flow.report.segment_seconds, 0.0);
  EXPECT_EQ (flow.labels.cols, kWidth);
}

TEST_F (RegistrationTest, OutputIsTheSourcePlusItsDisplacement)
{
  registration_->align (warped_);
  const SceneFlow& flow = registration_->getSceneFlow();
  int known = 0;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const auto& d = flow.displacement.at<cv::Vec3f> (v, u);
      const Eigen::Vector3f moved =
          (*reference_) (u, v).getVector3fMap() + Eigen::Vector3f (d[0], d[1], d[2]);
      if (!moved.allFinite()) {
        EXPECT_TRUE (std::isnan (warped_ (u, v).x));
        EXPECT_FALSE (warped_.is_dense);
        continue;
      }
      ++known;
      ASSERT_EQ (warped_ (u, v).getVector3fMap(), moved);
      ASSERT_EQ (warped_ (u, v).rgba, (*reference_) (u, v).rgba);
    }
  EXPECT_GT (known, 0.95 * kWidth * kHeight);
}

TEST_F (RegistrationTest, IndicesGiveAnOutputOfTheirSize)
{
  const auto indices = pcl::make_shared<pcl::Indices> (1000);
  std::iota (indices->begin(), indices->end(), 3000);
  const BaseRegistration::Ptr base = registration_;
  base->setIndices (indices);
  base->align (warped_);
  EXPECT_TRUE (base->hasConverged());
  EXPECT_EQ (warped_.width, 1000u);
  EXPECT_EQ (warped_.height, 1u);
  for (const auto& pair : registration_->getCorrespondences())
    EXPECT_TRUE (pair.index_query >= 3000 && pair.index_query < 4000);
  const SceneFlow& flow = registration_->getSceneFlow();
  EXPECT_EQ (flow.labels.at<int> (kHeight - 1, kWidth - 1), -1);

  base->setIndices (pcl::IndicesPtr()); // all again
  base->align (warped_);
  EXPECT_EQ (warped_.width, reference_->width);
  EXPECT_EQ (warped_.height, reference_->height);
}

TEST_F (RegistrationTest, ARectangleOfIndices)
{
  registration_->setIndices (10, 20, 30, 40);
  registration_->align (warped_);
  EXPECT_EQ (warped_.size(), 30u * 40u);
  EXPECT_EQ ((*registration_->getIndices())[0], 10 * kWidth + 20);
}

TEST_F (RegistrationTest, PointsWithoutDepthStayNaNAndScoresStayFinite)
{
  for (const Cloud::Ptr& cloud : {reference_, current_}) {
    for (int v = 40; v < 60; ++v)
      for (int u = 10; u < 50; ++u)
        (*cloud) (u, v).x = (*cloud) (u, v).y = (*cloud) (u, v).z = NAN;
    cloud->is_dense = false;
  }
  registration_->align (warped_);
  ASSERT_TRUE (registration_->hasConverged());
  EXPECT_TRUE (std::isnan (warped_ (20, 50).x));
  EXPECT_FALSE (warped_.is_dense);
  EXPECT_LT (registration_->getFitnessScore(), 1e-3);
  BaseRegistration& base = *registration_;
  EXPECT_LT (base.getFitnessScore(), 1e-3);
}

TEST_F (RegistrationTest, ZeroIsNoPointEither)
{
  const auto punch = [this] (float value) {
    for (const Cloud::Ptr& cloud : {reference_, current_})
      for (int v = 0; v < kHeight; ++v)
        for (int u = 0; u < kWidth; ++u)
          if ((u / 16 + v / 16) % 5 == 0)
            (*cloud) (u, v).getVector3fMap().setConstant (value);
    registration_->align (warped_);
    ASSERT_TRUE (registration_->hasConverged());
  };
  BaseRegistration& base = *registration_;
  punch (NAN);
  const std::size_t pairs = registration_->getCorrespondences().size();
  const double fitness = registration_->getFitnessScore();
  const double base_fitness = base.getFitnessScore();
  for (const float value : {0.0f, -1.0f}) {
    punch (value);
    for (const auto& pair : registration_->getCorrespondences())
      ASSERT_GT ((*current_)[pair.index_match].z, 0.0f);
    EXPECT_EQ (registration_->getCorrespondences().size(), pairs);
    EXPECT_EQ (registration_->getFitnessScore(), fitness);
    EXPECT_EQ (base.getFitnessScore(), base_fitness);
    EXPECT_TRUE (std::isnan (warped_ (2, 2).x));
  }
}

TEST_F (RegistrationTest, FitnessScoreIsTheMeanOverCorrespondencesInRange)
{
  registration_->align (warped_);
  double sum = 0.0;
  for (const auto& pair : registration_->getCorrespondences()) {
    const float expected = (warped_[pair.index_query].getVector3fMap() -
                            (*current_)[pair.index_match].getVector3fMap())
                               .squaredNorm();
    ASSERT_FLOAT_EQ (pair.distance, expected);
    sum += expected;
  }
  const auto n = static_cast<double> (registration_->getCorrespondences().size());
  EXPECT_GT (n, 0.8 * kWidth * kHeight);
  EXPECT_NEAR (registration_->getFitnessScore(), sum / n, 1e-9);
  EXPECT_EQ (registration_->getFitnessScore (-1.0), std::numeric_limits<double>::max());
}

TEST_F (RegistrationTest, BuildsNoTreeUntilSomebodyAsks)
{
  const auto tree = std::dynamic_pointer_cast<LazyKdTree<Point>> (
      registration_->getSearchMethodTarget());
  const auto reciprocal = std::dynamic_pointer_cast<LazyKdTree<Point>> (
      registration_->getSearchMethodSource());
  ASSERT_TRUE (tree && reciprocal);
  registration_->align (warped_);
  registration_->getFitnessScore();
  EXPECT_FALSE (tree->isBuilt());
  EXPECT_FALSE (reciprocal->isBuilt());
  static_cast<BaseRegistration&> (*registration_).getFitnessScore();
  EXPECT_TRUE (tree->isBuilt());
  registration_->setInputTarget (current_);
  registration_->align (warped_);
  EXPECT_FALSE (tree->isBuilt());
}

TEST_F (RegistrationTest, CanBeUsedAgain)
{
  registration_->align (warped_);
  const Eigen::Matrix4f first = registration_->getFinalTransformation();
  Cloud again;
  registration_->align (again);
  EXPECT_EQ (registration_->getFinalTransformation(), first);
  registration_->setInputSource (current_);
  registration_->setInputTarget (reference_);
  registration_->align (again);
  EXPECT_TRUE (registration_->hasConverged());
  EXPECT_LT (
      largestError (registration_->getFinalTransformation().inverse(), *reference_),
      0.01);
}

TEST_F (RegistrationTest, CallsTheVisualizerWithTheWarpedSource)
{
  int calls = 0;
  std::function<BaseRegistration::UpdateVisualizerCallbackSignature> callback =
      [&] (const Cloud& source,
           const pcl::Indices& points,
           const Cloud& target,
           const pcl::Indices& matches) {
        ++calls;
        EXPECT_EQ (points.size(), matches.size());
        for (std::size_t i = 0; i < points.size(); ++i)
          ASSERT_LT (
              (source[points[i]].getVector3fMap() - target[matches[i]].getVector3fMap())
                  .norm(),
              0.5f);
      };
  BaseRegistration& base = *registration_;
  EXPECT_TRUE (base.registerVisualizationCallback (callback)); // PCL calls it here, too
  registration_->setIndices (10, 20, 30, 40);
  base.align (warped_);
  EXPECT_EQ (calls, 2);
}

TEST_F (RegistrationTest, TheBasesIterationLimitIsTheSolvers)
{
  BaseRegistration& base = *registration_;
  EXPECT_EQ (base.getMaximumIterations(), SolverParameters{}.max_iterations);
  base.setMaximumIterations (3);
  EXPECT_EQ (registration_->getSolverParameters().max_iterations, 3);
  SolverParameters parameters;
  parameters.max_iterations = 5;
  registration_->setSolverParameters (parameters);
  EXPECT_EQ (base.getMaximumIterations(), 5);
}

TEST_F (RegistrationTest, TakesLabelsClustersNormalsAndAGuess)
{
  const auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (kWidth, kHeight);
  for (std::size_t i = 0; i < labels->size(); ++i)
    (*labels)[i].label = i % kWidth < kWidth / 2 ? 7 : 9;
  registration_->setSegmentation (labels);
  registration_->align (warped_, RigidPair::motion().matrix());
  EXPECT_TRUE (registration_->hasConverged());
  EXPECT_EQ (registration_->getSceneFlow().segments.size(), 2u);

  std::vector<pcl::PointIndices> clusters (1);
  clusters[0].indices.resize (kWidth * kHeight / 2);
  std::iota (clusters[0].indices.begin(), clusters[0].indices.end(), 0);
  registration_->setSegmentation (clusters);
  registration_->align (warped_);
  EXPECT_EQ (registration_->getSceneFlow().segments.size(), 1u);
  EXPECT_TRUE (std::isnan (warped_ (5, kHeight - 1).x)); // in no segment

  registration_->clearSegmentation();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>> (
      kWidth, kHeight, pcl::Normal (0.0f, 0.0f, -1.0f));
  (*normals)[5].normal_x = NAN;
  registration_->setSourceNormals (normals);
  registration_->align (warped_);
  EXPECT_EQ (registration_->getReport().message, "");
}

/** The pair as clouds of another type, aligned; its displacements, and what they are
 * of. */
template <typename PointT>
SceneFlow
alignedAs ()
{
  PiecewiseRigidRegistration<PointT> registration;
  const auto source = pcl::make_shared<pcl::PointCloud<PointT>>();
  const auto target = pcl::make_shared<pcl::PointCloud<PointT>>();
  pcl::copyPointCloud (*RigidPair::reference(), *source);
  pcl::copyPointCloud (*RigidPair::current(), *target);
  if constexpr (pcl::traits::has_intensity<PointT>::value)
    for (const auto& [to, from] :
         {std::pair (source, RigidPair::reference()), {target, RigidPair::current()}})
      for (std::size_t i = 0; i < from->size(); ++i)
        (*to)[i].intensity = static_cast<float> ((*from)[i].g) / 255.0f;
  registration.setInputSource (source);
  registration.setInputTarget (target);
  pcl::PointCloud<PointT> warped;
  registration.align (warped);
  EXPECT_TRUE (registration.hasConverged());
  return registration.getSceneFlow();
}

double
largestDifference (const SceneFlow& a, const SceneFlow& b)
{
  cv::Mat difference;
  cv::absdiff (a.displacement, b.displacement, difference);
  cv::patchNaNs (difference, 0.0);
  double largest = 0.0;
  cv::minMaxLoc (difference.reshape (1), nullptr, &largest);
  return largest;
}

TEST (RegistrationTypes, NormalsInThePointsChangeNothing)
{
  const SceneFlow plain = alignedAs<pcl::PointXYZ>();
  const SceneFlow grey = alignedAs<pcl::PointXYZI>();
  EXPECT_EQ (largestDifference (alignedAs<pcl::PointNormal>(), plain), 0.0);
  EXPECT_EQ (largestDifference (alignedAs<pcl::PointXYZINormal>(), grey), 0.0);
  EXPECT_GT (largestDifference (plain, grey), 0.0);
}

} // namespace
