// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "wavy_pair.h"
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/result_files.h>

/** Eigen's functions for aligned types, which the library uses, too: a program must not
 * replace the library's by its own. */
double
ownDecompositions ()
{
  const Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Identity() * 4.0;
  const Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Ones();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen (a);
  return a.ldlt().solve (b).sum() + a.llt().solve (b).sum() + eigen.eigenvalues().sum();
}

int
main (int, char** argv)
{
  if (std::abs (ownDecompositions() - 27.0) > 1e-9 || !registers<pcl::PointXYZ>())
    return 1;
  // Clouds that the io library fills and this code enlarges and frees.
  const auto cloud = pcl_msf::io::readOrganizedCloud (argv[1]);
  cloud->push_back (cloud->front());
  return cloud->size() == 3 * 2 + 1 ? 0 : 1;
}
