// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Everything that is measured of one method on one pair of frames; NaN = not
 * known. `columns ()` says what each is. */
struct Score {
  double points, coverage;
  double epe_all, epe_visible, epe_occluded, epe_median;
  double rms_all, rms_visible, rms_occluded;
  double aae_all, aae_visible, aae_occluded;
  double out_all, out_visible, out_occluded;
  double epe3d_all, epe3d_visible, epe3d_occluded, epe3d_median;
  double acc5_all, acc5_visible, acc5_occluded;
  double acc1_all, acc1_visible, acc1_occluded;
  double segments, groups, ari, purity;
  double segment_rot, segment_trans, segment_rot_median, segment_trans_median;
  double nees, nees_median, nees_groups;
  double ause, ause_residual;
  double ego_rot, ego_trans;
  double seen, photo_all_mean, photo_all_median, photo_mean, photo_median;
  double depth_mean, depth_median, depth_sigmas;
  double converged, iterations;
  double sec, sec_frame, sec_segment, sec_start, sec_solve, sec_result, peak_mb;
  std::array<double, 6> motion;      ///< estimated dominant motion, to_from_from
  std::array<double, 6> true_motion; ///< that of the camera

  /** \brief All unknown. */
  Score();
};

/** \brief One number of a Score. */
struct Column {
  std::string name;
  const char* help;
  double Score::*value;
  int decimals;        ///< what a table prints
  bool is_time{false}; ///< differs from run to run
};

/** \brief All numbers but the motions, in the order of the CSV. */
const std::vector<Column>&
columns ();

/** \brief The column of a name. \throws std::out_of_range */
const Column&
column (const std::string& name);

/** \brief One line of the result: a method on a pair of frames. */
struct Row {
  std::size_t pair{0}; ///< number of the pair in the whole run, from 0 on
  std::string dataset;
  std::string sequence;
  int from{0};
  int to{0};
  std::string method;
  Score score;
};

} // namespace pcl_msf::tool
