// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <ceres/solver.h>

namespace pcl_msf {

/** \brief Has Ceres solve by sparse Cholesky factorization in the calling thread.
 *
 * Ceres would take CHOLMOD, which factorizes by OpenMP, whatever Ceres' num_threads
 * says: threads that nobody asked for, and a process forked later waits for them. */
inline void
useSparseCholesky (ceres::Solver::Options& options)
{
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  if (ceres::IsSparseLinearAlgebraLibraryTypeAvailable (ceres::EIGEN_SPARSE))
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
}

} // namespace pcl_msf
