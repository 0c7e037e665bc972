// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Show progress, stop when the user wants, or when the time is up.
#include "example_clouds.h"
#include <pcl_msf/piecewise_rigid_registration.h>

#include <atomic>
#include <iostream>

int
main ()
{
  pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGBA> registration;
  registration.setInputSource (exampleCloud (0));
  registration.setInputTarget (exampleCloud (1));
  pcl_msf::SolverParameters solver;
  solver.max_seconds = 10.0; // then the best result so far

  std::atomic<bool> wanted{true}; // a button may set it to false
  solver.progress = [&] (const pcl_msf::Progress& progress) {
    std::cout << progress.stage << ": " << static_cast<int> (100 * progress.fraction)
              << " %, energy " << progress.cost << "\n";
    if (progress.fraction > 0.5)
      wanted = false;
    return wanted.load(); // false cancels
  };
  registration.setSolverParameters (solver);

  Cloud warped;
  registration.align (warped);
  const pcl_msf::Report& report = registration.getReport();
  std::cout << pcl_msf::toString (report.stop_reason) << " after " << report.iterations
            << " iterations; the result so far is usable\n";
  return report.stop_reason == pcl_msf::StopReason::Cancelled ? 0 : 1;
}
