// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

namespace pcl_msf::tool {

/** \brief Largest resident memory of this process since the object was made; since its
 * start where the system cannot begin anew. */
class PeakMemory {
public:
  PeakMemory();

  /** \brief NaN where the system does not tell. */
  double
  megabytes () const;
};

} // namespace pcl_msf::tool
