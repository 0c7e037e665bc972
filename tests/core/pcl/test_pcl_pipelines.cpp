// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Where PCL's own machinery runs a registration through its base alone.
#include <pcl/registration/icp.h>
#include <pcl/registration/incremental_registration.h>
#include <pcl/registration/meta_registration.h>

#include <gtest/gtest.h>

#include "support/chain_clouds.h"
#include <pcl_msf/piecewise_rigid_registration.h>

#include <map>
#include <string>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;
using Base = pcl::Registration<Point, Point>;

/** As chosen at run time. */
Base::Ptr
registrationOf (const std::string& name)
{
  if (name == "icp")
    return pcl::make_shared<pcl::IterativeClosestPoint<Point, Point>>();
  return pcl::make_shared<PiecewiseRigidRegistration<Point>>();
}

/** A rigid body as seen by a scanner that has moved `steps` times, drawn anew. */
Cloud::Ptr
viewAfter (int steps)
{
  BoxChain body;
  body.boxes = 1;
  body.size.x() = 1.2;
  body.root = {};
  const RigidPose step{{0.0, 0.03, 0.05, 0.01, 0.02, -0.01}};
  for (int k = 0; k < steps; ++k)
    body.root = step * body.root;
  return cloudOf<Point> (drawChain (body, 2000, true, 61 + steps).points);
}

/** Where the corner of the body is after `steps`, and after coming back by a matrix. */
double
wayFromHome (int steps, const Eigen::Matrix4f& back)
{
  const RigidPose step{{0.0, 0.03, 0.05, 0.01, 0.02, -0.01}};
  const Eigen::Vector3d corner (1.2, 0.11, 0.08);
  Eigen::Vector3d moved = corner;
  for (int k = 0; k < steps; ++k)
    moved = step * moved;
  return (RigidPose::fromMatrix (back) * moved - corner).norm();
}

TEST (PclPipelines, BehindABasePointerChosenAtRunTime)
{
  const BoxChain chain;
  const Cloud::Ptr source = cloudOf<Point> (drawChain (chain, 5000, false, 71).points);
  const Cloud::Ptr target = cloudOf<Point> (drawChain (chain, 5000, true, 72).points);
  std::map<std::string, double> errors;
  for (const char* name : {"icp", "msf"}) {
    const Base::Ptr registration = registrationOf (name);
    registration->setInputSource (source);
    registration->setInputTarget (target);
    Cloud warped;
    registration->align (warped);
    EXPECT_TRUE (registration->hasConverged()) << name;
    EXPECT_LT (registration->getFitnessScore(), 0.01) << name;
    errors[name] = meanChainError (chain, *source, warped);
  }
  EXPECT_LT (errors["msf"], 1e-3);
  EXPECT_GT (errors["icp"], 10.0 * errors["msf"]);
}

TEST (PclPipelines, IncrementalRegistrationFollowsAScanner)
{
  pcl::registration::IncrementalRegistration<Point> incremental;
  incremental.setRegistration (registrationOf ("msf"));
  for (int k = 0; k < 4; ++k) {
    ASSERT_TRUE (incremental.registerCloud (viewAfter (k))) << k;
    EXPECT_LT (wayFromHome (k, incremental.getAbsoluteTransform()), 3e-3) << k;
  }
}

TEST (PclPipelines, MetaRegistrationMakesAMap)
{
  pcl::registration::MetaRegistration<Point> meta;
  meta.setRegistration (registrationOf ("msf"));
  for (int k = 0; k < 4; ++k) {
    ASSERT_TRUE (meta.registerCloud (viewAfter (k))) << k;
    EXPECT_LT (wayFromHome (k, meta.getAbsoluteTransform()), 3e-3) << k;
  }
  const auto map = meta.getMetaCloud();
  ASSERT_EQ (map->size(), 8000u);
  BoxChain body;
  for (const Point& p : *map) { // all on the body's outside
    const Eigen::Vector3d off =
        (p.getVector3fMap().cast<double>() - Eigen::Vector3d (0.6, 0.0, 0.0))
            .cwiseAbs() -
        0.5 * Eigen::Vector3d (1.2, body.size.y(), body.size.z());
    ASSERT_NEAR (off.maxCoeff(), 0.0, 8e-3);
  }
}

} // namespace
