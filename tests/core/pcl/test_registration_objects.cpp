// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cstring>
#include <numeric>
#include <thread>

/* Objects that stay whole: copies, clouds that are input and output, clouds that are
 * filled anew in place. */
namespace {

using namespace pcl_msf;
using testing::HasSubstr;

using Point = pcl::PointXYZRGB;
using Cloud = pcl::PointCloud<Point>;
using Registration = PiecewiseRigidRegistration<Point>;
using BaseRegistration = pcl::Registration<Point, Point>;

constexpr int kWidth = RigidPair::kWidth;
constexpr int kHeight = RigidPair::kHeight;

pcl::IndicesPtr
firstIndices (int count)
{
  auto indices = pcl::make_shared<pcl::Indices> (count);
  std::iota (indices->begin(), indices->end(), 0);
  return indices;
}

/** A corner of a cloud. */
Cloud
corner (const Cloud& cloud, std::uint32_t width, std::uint32_t height)
{
  Cloud part (width, height);
  for (std::uint32_t v = 0; v < height; ++v)
    for (std::uint32_t u = 0; u < width; ++u)
      part (u, v) = cloud (u % cloud.width, v % cloud.height);
  return part;
}

bool
samePoints (const Cloud& a, const Cloud& b)
{
  return a.width == b.width && a.height == b.height && a.size() == b.size() &&
         std::equal (
             a.begin(), a.end(), b.begin(), [] (const Point& p, const Point& q) {
               return std::memcmp (p.data, q.data, 3 * sizeof (float)) == 0 &&
                      p.rgba == q.rgba;
             });
}

double
baseFitness (BaseRegistration& registration)
{
  return registration.getFitnessScore();
}

class Objects : public testing::Test {
protected:
  void
  give (Registration& registration) const
  {
    registration.setInputSource (source_);
    registration.setInputTarget (target_);
  }

  /** Aligns a fresh registration of the clouds as they are. */
  Cloud
  alignedAlone (double* base_fitness = nullptr) const
  {
    Registration registration;
    give (registration);
    Cloud output;
    registration.align (output);
    EXPECT_TRUE (registration.hasConverged());
    if (base_fitness)
      *base_fitness = baseFitness (registration);
    return output;
  }

  /** Aligns behind the base pointer, as the clouds are. \return what was printed */
  std::string
  failedAlign (Registration& registration, Cloud& output) const
  {
    BaseRegistration& base = registration;
    testing::internal::CaptureStderr();
    EXPECT_NO_THROW (base.align (output));
    EXPECT_FALSE (base.hasConverged());
    EXPECT_EQ (registration.getReport().stop_reason, StopReason::InvalidInput);
    return testing::internal::GetCapturedStderr();
  }

  Cloud::Ptr source_ = RigidPair::reference();
  Cloud::Ptr target_ = RigidPair::current();
  Cloud output_;
};

using Copies = Objects;

TEST_F (Copies, OwnTheirCorrespondencesAndSearchObjects)
{
  const Registration prototype;
  std::vector<Registration> workers (2, prototype);
  give (workers[0]);
  workers[0].align (output_);
  const double fitness = workers[0].getFitnessScore();
  const double base_fitness = baseFitness (workers[0]);
  const std::size_t pairs = workers[0].getCorrespondences().size();

  workers[1] = workers[0];
  EXPECT_EQ (workers[1].getFitnessScore(), fitness) << "a copy starts with the result";
  EXPECT_EQ (baseFitness (workers[1]), base_fitness);
  EXPECT_TRUE (samePoints (workers[1].getWarpedCloud (1), output_));
  workers[1].setInputTarget (source_);
  workers[1].align (output_);
  EXPECT_LT (workers[1].getFitnessScore(), 1e-9);
  EXPECT_EQ (workers[0].getFitnessScore(), fitness);
  EXPECT_EQ (workers[0].getCorrespondences().size(), pairs);
  EXPECT_EQ (baseFitness (workers[0]), base_fitness);
  EXPECT_NE (workers[0].getSearchMethodTarget(), workers[1].getSearchMethodTarget());
  EXPECT_NE (workers[0].getSearchMethodSource(), workers[1].getSearchMethodSource());
  EXPECT_NE (workers[0].getIndices(), workers[1].getIndices());
}

TEST_F (Copies, ShareOnlyASearchObjectThatIsNeverRecomputed)
{
  Registration registration;
  const auto tree = pcl::make_shared<pcl::search::KdTree<Point>>();
  tree->setInputCloud (target_);
  registration.setSearchMethodTarget (tree, true);
  EXPECT_EQ (Registration (registration).getSearchMethodTarget(), tree);
  registration.setSearchMethodTarget (tree);
  EXPECT_NE (Registration (registration).getSearchMethodTarget(), tree);
}

TEST_F (Copies, AlignInTwoThreads)
{
  const Cloud alone = alignedAlone();
  Registration prototype;
  prototype.setNumberOfThreads (1);
  give (prototype);
  std::vector<Registration> workers (2, prototype);
  workers[1].setInputTarget (source_);
  std::vector<Cloud> outputs (2);
  std::vector<std::thread> threads;
  for (int k = 0; k < 2; ++k)
    threads.emplace_back ([&, k] { workers[k].align (outputs[k]); });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_TRUE (samePoints (outputs[0], alone));
  EXPECT_LT (workers[1].getFitnessScore(), 1e-9);
  EXPECT_GT (workers[0].getFitnessScore(), 1e-9);
}

using InPlace = Objects;

TEST_F (InPlace, TheSourceCanBeTheOutput)
{
  const Cloud wanted = alignedAlone();
  Registration registration;
  give (registration);
  registration.align (*source_);
  ASSERT_TRUE (registration.hasConverged());
  EXPECT_TRUE (samePoints (*source_, wanted));
  EXPECT_TRUE (samePoints (registration.getWarpedCloud (1), wanted));
}

TEST_F (InPlace, TheSourceCanBeTheOutputOfSomeOfItsPoints)
{
  const Cloud wanted = alignedAlone();
  Registration registration;
  give (registration);
  registration.setIndices (40, 50, 30, 60);
  BaseRegistration& base = registration;
  base.align (*source_);
  ASSERT_TRUE (base.hasConverged());
  ASSERT_EQ (source_->size(), 30U * 60U);
  EXPECT_EQ (source_->height, 1U);
  const Cloud warped = registration.getWarpedCloud (1);
  ASSERT_EQ (warped.size(), wanted.size());
  EXPECT_EQ ((*source_)[0].x, warped (50, 40).x);
  EXPECT_THAT (failedAlign (registration, output_), HasSubstr ("rectangle"));
}

TEST_F (InPlace, ATargetIsRefusedAsOutputAndLeftAlone)
{
  Registration registration;
  registration.setInputSource (source_);
  registration.setInputTargets ({target_, RigidPair::current()});
  registration.align (output_);
  ASSERT_TRUE (registration.hasConverged());
  testing::internal::CaptureStderr();
  registration.align (*target_);
  EXPECT_THAT (testing::internal::GetCapturedStderr(), HasSubstr ("another cloud"));
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_TRUE (registration.getCorrespondences().empty());
  EXPECT_EQ (registration.getFinalTransformation(), Eigen::Matrix4f::Identity());
  EXPECT_TRUE (samePoints (*target_, *RigidPair::current()));
  EXPECT_THAT (failedAlign (registration, *target_), HasSubstr ("another cloud"));
}

TEST_F (InPlace, RefilledCloudsAreJudgedInAlign)
{
  struct Refill {
    std::uint32_t width, height;
    const char* remedy;
  };
  for (const Refill& refill : {Refill{40, 30, "setIndices"},
                               {0, 0, "setInputSource"},
                               {kWidth * kHeight, 1, "setKeepOrganized"},
                               {2 * kWidth, 2 * kHeight, "clouds of one size"}}) {
    SCOPED_TRACE (refill.remedy);
    source_ = RigidPair::reference();
    Registration registration;
    registration.setCorrespondence (CorrespondenceMethod::Projective);
    give (registration);
    registration.setIndices (firstIndices (kWidth * kHeight));
    registration.align (output_);
    ASSERT_TRUE (registration.hasConverged());
    *source_ = corner (*RigidPair::reference(), refill.width, refill.height);
    EXPECT_THAT (failedAlign (registration, output_), HasSubstr (refill.remedy));
    EXPECT_LE (output_.size(), source_->size());
    EXPECT_TRUE (registration.getWarpedCloud (1).empty());
    *source_ = *RigidPair::reference();
    registration.align (output_);
    EXPECT_TRUE (registration.hasConverged()) << "the indices fit again";
  }
}

TEST_F (InPlace, RefilledTargetsAreJudgedInAlign)
{
  Registration registration;
  give (registration);
  *target_ = corner (*target_, 40, 30);
  EXPECT_THAT (failedAlign (registration, output_), HasSubstr ("clouds of one size"));
  EXPECT_TRUE (samePoints (output_, *source_)) << "the untransformed source";
  target_->clear();
  EXPECT_THAT (failedAlign (registration, output_), HasSubstr ("the target is empty"));
}

TEST_F (InPlace, LabelsClustersAndNormalsAreJudgedInAlign)
{
  const auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (kWidth, kHeight);
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>> (
      kWidth, kHeight, pcl::Normal (0.0F, 0.0F, -1.0F));
  std::vector<pcl::PointIndices> clusters (1);
  clusters[0].indices = *firstIndices (kWidth * kHeight);
  Registration labelled, clustered, with_normals;
  labelled.setSegmentation (labels);
  clustered.setSegmentation (clusters);
  with_normals.setSourceNormals (normals);
  for (Registration* registration : {&labelled, &clustered, &with_normals}) {
    give (*registration);
    registration->align (output_);
    EXPECT_TRUE (registration->hasConverged());
  }
  *source_ = corner (*source_, 80, 60);
  *target_ = corner (*target_, 80, 60);
  EXPECT_THAT (failedAlign (labelled, output_), HasSubstr ("clearSegmentation"));
  EXPECT_THAT (failedAlign (clustered, output_), HasSubstr ("setSegmentation"));
  EXPECT_THAT (failedAlign (with_normals, output_), HasSubstr ("setSourceNormals"));
  labels->clear();
  EXPECT_THAT (failedAlign (labelled, output_), HasSubstr ("clearSegmentation"));
}

TEST_F (InPlace, IndicesAreCopiedWhenSet)
{
  const auto indices = firstIndices (3);
  Registration registration;
  give (registration);
  registration.setIndices (indices);
  indices->assign (5, -1);
  registration.align (output_);
  EXPECT_TRUE (registration.hasConverged());
  EXPECT_EQ (output_.size(), 3U);
  EXPECT_THAT (*registration.getIndices(), testing::ElementsAre (0, 1, 2));
}

TEST_F (InPlace, ResultsBelongToTheLastAlign)
{
  Registration registration;
  give (registration);
  registration.align (output_);
  *source_ = corner (*source_, 40, 30);
  target_->clear();
  EXPECT_TRUE (samePoints (registration.getWarpedCloud (1), output_));
}

TEST_F (InPlace, TheSearchObjectFollowsTheTarget)
{
  double right = 0.0;
  alignedAlone (&right);
  Registration registration;
  const auto changing = RigidPair::reference();
  registration.setInputSource (source_);
  registration.setInputTarget (changing);
  registration.align (output_);
  EXPECT_LT (baseFitness (registration), 1e-9);
  *changing = *target_;
  registration.align (output_);
  EXPECT_EQ (baseFitness (registration), right);
}

TEST_F (Objects, HeaderAndSensorPoseAreTheSources)
{
  source_->header.frame_id = "optical";
  source_->header.stamp = 7;
  source_->sensor_origin_ = {1.0F, 2.0F, 3.0F, 0.0F};
  source_->sensor_orientation_ = {0.0F, 1.0F, 0.0F, 0.0F};
  target_->sensor_origin_ = {4.0F, 5.0F, 6.0F, 0.0F};
  const auto expectSources = [this] (const Cloud& cloud) {
    EXPECT_EQ (cloud.header.frame_id, "optical");
    EXPECT_EQ (cloud.header.stamp, 7U);
    EXPECT_EQ (cloud.sensor_origin_, source_->sensor_origin_);
    EXPECT_EQ (cloud.sensor_orientation_.coeffs(),
               source_->sensor_orientation_.coeffs());
  };
  Registration registration;
  give (registration);
  registration.align (output_);
  expectSources (output_);
  expectSources (registration.getWarpedCloud (1));
  registration.setIndices (firstIndices (500));
  Cloud some;
  registration.align (some);
  expectSources (some);
  target_->clear();
  Cloud failed;
  failedAlign (registration, failed);
  EXPECT_EQ (failed.size(), 500U);
  expectSources (failed);
}

} // namespace
