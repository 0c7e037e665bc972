// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Geometry>

namespace pcl_msf::synthetic {

/** \brief A rigid motion. Without alignment, as all matrices that functions pass:
 * Eigen's functions for aligned ones would be shared with those of the program that the
 * library is linked into, whose alignment may be another. */
using Isometry = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

} // namespace pcl_msf::synthetic
