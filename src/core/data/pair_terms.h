// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_term.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace pcl_msf {

/** \brief One pair of frames, as the steps that form bodies see it. */
struct PairTerms {
  int pair;               ///< index of its poses in the state
  const DataTerm* all;    ///< every point, linearized at the state
  const DataTerm* sample; ///< some of the points, to compare poses with; null when
                          ///< the points were carried, as those of pairs that
                          ///< don't start at the reference
  double residual_scale;  ///< see residualScale
};

/** \brief Those whose points are the segments' own, not carried to another frame. */
inline std::vector<PairTerms>
fromReference (const std::vector<PairTerms>& terms)
{
  std::vector<PairTerms> own;
  std::copy_if (terms.begin(),
                terms.end(),
                std::back_inserter (own),
                [] (const PairTerms& t) { return t.sample != nullptr; });
  return own;
}

} // namespace pcl_msf
