// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_flow.h>

namespace pcl_msf {

/** \brief How a part turns against another one.
 * \param seam a point between them, source frame */
CloudJoint
jointBetween (const CloudPart& parent,
              const CloudPart& child,
              const Eigen::Vector3d& seam);

} // namespace pcl_msf
