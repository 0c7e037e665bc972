// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/methods/method.h"
#include "score.h"

namespace pcl_msf::tool {

/** \brief What scores need of a pair beside the estimates; computed once a pair. */
class PairScorer {
public:
  explicit PairScorer (const PairData& pair);

  /** \brief Scores an estimate. \param seen mask of the points over which residuals
   * are taken, CV_8UC1, 255 = yes; empty = all with depth */
  Score
  score (const Estimate& estimate, const cv::Mat& seen) const;

private:
  void
  scoreFlow (const Estimate& estimate, Score& score) const;
  void
  scoreSceneFlow (const Estimate& estimate, Score& score) const;
  void
  scoreMotions (const Estimate& estimate, Score& score) const;
  void
  scoreDeviation (const Estimate& estimate, Score& score) const;
  void
  scoreResiduals (const Estimate& estimate, const cv::Mat& seen, Score& score) const;

  const PairData& pair_;
  cv::Mat all_, visible_, occluded_; ///< masks
  cv::Mat points_;
  double inverse_depth_noise_;
};

} // namespace pcl_msf::tool
