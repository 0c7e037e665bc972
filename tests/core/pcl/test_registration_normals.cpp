// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <gtest/gtest.h>

#include "support/chain_clouds.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cstring>
#include <limits>

/* Normals of the source from outside, of clouds without a grid. */
namespace {

using namespace pcl_msf;
using pcl_msf::testing::BoxChain;
using pcl_msf::testing::ChainCloud;
using pcl_msf::testing::cloudOf;
using pcl_msf::testing::drawChain;
using ::testing::HasSubstr;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZ>;

constexpr int kPoints = 2000;

class GivenNormals : public ::testing::Test {
protected:
  GivenNormals()
  {
    chain.boxes = 2;
    drawn = drawChain (chain, kPoints, false, 1);
    source = cloudOf<pcl::PointXYZ> (drawn.points);
    registration.setInputSource (source);
    registration.setInputTarget (
        cloudOf<pcl::PointXYZ> (drawChain (chain, kPoints, true, 2).points));
  }
  Cloud
  warped (const Normals::ConstPtr& normals)
  {
    registration.setSourceNormals (normals);
    Cloud cloud;
    registration.align (cloud);
    EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
    return cloud;
  }
  double
  meanError (const Cloud& cloud) const
  {
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i)
      sum += (cloud[i].getVector3fMap().cast<double>() -
              chain.pose (drawn.box[i]) * drawn.rest[i].cast<double>())
                 .norm();
    return sum / kPoints;
  }
  static Normals::Ptr
  same (const pcl::Normal& normal)
  {
    return pcl::make_shared<Normals> (kPoints, 1, normal);
  }

  BoxChain chain;
  ChainCloud drawn;
  Cloud::Ptr source;
  Registration registration;
};

bool
sameBits (const Cloud& a, const Cloud& b)
{
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i)
    same = std::memcmp (a[i].data, b[i].data, 3 * sizeof (float)) == 0;
  return same;
}

TEST_F (GivenNormals, OfPclFaceTheViewpointAndServe)
{
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (source);
  estimation.setSearchMethod (pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch (10);
  estimation.setViewPoint (0.0F, 0.0F, 10.0F); // of the lower side they look inwards
  auto normals = pcl::make_shared<Normals>();
  estimation.compute (*normals);
  EXPECT_LT (meanError (warped (normals)), 2e-3);
}

TEST_F (GivenNormals, AreUsed)
{
  const Cloud own = warped (nullptr);
  // One that no side of a box has, whatever else: the result is another one.
  registration.setSourceNormals (same ({0.6F, 0.0F, 0.8F}));
  Cloud skewed;
  registration.align (skewed);
  EXPECT_FALSE (sameBits (skewed, own));
}

TEST_F (GivenNormals, AreComputedWhereTheyAreUnknown)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Cloud own = warped (nullptr);
  EXPECT_TRUE (sameBits (warped (same ({nan, nan, nan})), own));
  EXPECT_TRUE (sameBits (warped (same ({0.0F, 0.0F, 0.0F})), own));
}

TEST_F (GivenNormals, AreThoseOfTheChosenPoints)
{
  auto indices = pcl::make_shared<pcl::Indices>();
  auto chosen = pcl::make_shared<Cloud>();
  auto normals = same ({0.6F, 0.0F, 0.8F}); // of the others
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 1; i < kPoints; i += 2) {
    indices->push_back (i);
    chosen->push_back ((*source)[i]);
    (*normals)[i] = {nan, nan, nan};
  }
  registration.setInputSource (chosen);
  const Cloud own = warped (nullptr);
  registration.setInputSource (source);
  registration.setIndices (indices);
  EXPECT_TRUE (sameBits (warped (normals), own));
}

TEST_F (GivenNormals, OfAnotherCloudAreRefused)
{
  registration.setSourceNormals (pcl::make_shared<Normals> (kPoints - 1, 1));
  Cloud cloud;
  ::testing::internal::CaptureStderr();
  registration.align (cloud);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_THAT (said, HasSubstr ("setSourceNormals"));
  EXPECT_THAT (said, HasSubstr ("1999 normals for 2000 points"));
}

} // namespace
