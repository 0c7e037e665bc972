// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// In a pipeline that takes any pcl::Registration and chooses at run time.
#include <pcl/registration/icp.h>

#include "example_clouds.h"
#include <pcl_msf/piecewise_rigid_registration.h>

#include <iostream>
#include <string>

using Registration = pcl::Registration<pcl::PointXYZRGBA, pcl::PointXYZRGBA>;

Registration::Ptr
makeRegistration (const std::string& name)
{
  if (name == "icp")
    return pcl::make_shared<
        pcl::IterativeClosestPoint<pcl::PointXYZRGBA, pcl::PointXYZRGBA>>();
  return pcl::make_shared<pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGBA>>();
}

int
main (int argc, char** argv)
{
  const Registration::Ptr registration = makeRegistration (argc > 1 ? argv[1] : "msf");
  registration->setInputSource (exampleCloud (0));
  registration->setInputTarget (exampleCloud (1));
  Cloud aligned;
  registration->align (aligned);
  std::cout << registration->getClassName() << ": "
            << (registration->hasConverged() ? "converged" : "not converged") << "\n"
            << registration->getFinalTransformation() << "\n";

  // What PCL's interface has no word for.
  using PiecewiseRigid = pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGBA>;
  if (const auto* own = dynamic_cast<const PiecewiseRigid*> (registration.get()))
    std::cout << own->getSceneFlow().groups << " motion groups\n";
  return registration->hasConverged() ? 0 : 1;
}
