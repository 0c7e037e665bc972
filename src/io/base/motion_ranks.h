// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf::io {

/** \brief Motion groups in the order in which pictures colour them: the dominant one
 * first, the others by number of points. */
class PCL_MSF_EXPORT MotionRanks {
public:
  explicit MotionRanks (const SceneFlow& scene_flow);

  /** \brief Rank of a segment: 0 = the dominant group, undetermined () when its motion
   * is not known, -1 when there is no such segment. */
  int
  rank (int label) const;

  /** \brief Number of groups, and the rank of segments that belong to none. */
  int
  undetermined () const
  {
    return static_cast<int> (points_.size());
  }

  /** \brief Points of the group with a rank. */
  long
  points (int rank) const
  {
    return points_[rank];
  }

  /** \brief Points of all segments. */
  long
  allPoints () const
  {
    return all_points_;
  }

  /** \brief Ranks in place of labels, CV_32SC1; negative labels stay. */
  cv::Mat
  image (const cv::Mat& labels) const;

private:
  std::vector<int> rank_of_; ///< per segment
  std::vector<long> points_; ///< per rank
  long all_points_{0};
};

} // namespace pcl_msf::io
