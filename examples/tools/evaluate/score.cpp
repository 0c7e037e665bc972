// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "score.h"

#include <limits>
#include <stdexcept>

namespace pcl_msf::tool {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Columns = std::vector<Column>;

void
addFlowColumns (Columns& c)
{
  c.push_back ({"points", "points of the first frame with depth", &Score::points, 0});
  c.push_back ({"coverage",
                "share of visible points with known truth that have a known estimate",
                &Score::coverage,
                3});
  c.push_back ({"epe_all",
                "average end-point error, px; all points with depth; unknown = zero",
                &Score::epe_all,
                3});
  c.push_back (
      {"epe_visible", "the same, points seen in both frames", &Score::epe_visible, 3});
  c.push_back ({"epe_occluded", "the same, hidden points", &Score::epe_occluded, 3});
  c.push_back ({"epe_median", "median of visible points, px", &Score::epe_median, 3});
  c.push_back ({"rms_all", "root mean square end-point error, px", &Score::rms_all, 3});
  c.push_back ({"rms_visible", "the same, visible", &Score::rms_visible, 3});
  c.push_back ({"rms_occluded", "the same, hidden", &Score::rms_occluded, 3});
  c.push_back ({"aae_all", "average angular error, deg", &Score::aae_all, 2});
  c.push_back ({"aae_visible", "the same, visible", &Score::aae_visible, 2});
  c.push_back ({"aae_occluded", "the same, hidden", &Score::aae_occluded, 2});
  c.push_back ({"out_all", "share of errors > 3 px and > 5 %", &Score::out_all, 4});
  c.push_back ({"out_visible", "the same, visible", &Score::out_visible, 4});
  c.push_back ({"out_occluded", "the same, hidden", &Score::out_occluded, 4});
}

void
addSceneFlowColumns (Columns& c)
{
  c.push_back ({"epe3d_all", "average 3D end-point error, m", &Score::epe3d_all, 5});
  c.push_back ({"epe3d_visible", "the same, visible", &Score::epe3d_visible, 5});
  c.push_back ({"epe3d_occluded", "the same, hidden", &Score::epe3d_occluded, 5});
  c.push_back (
      {"epe3d_median", "median of visible points, m", &Score::epe3d_median, 5});
  c.push_back ({"acc5_all", "share of 3D errors < 5 cm", &Score::acc5_all, 3});
  c.push_back ({"acc5_visible", "the same, visible", &Score::acc5_visible, 3});
  c.push_back ({"acc5_occluded", "the same, hidden", &Score::acc5_occluded, 3});
  c.push_back ({"acc1_all", "share of 3D errors < 1 cm", &Score::acc1_all, 3});
  c.push_back ({"acc1_visible", "the same, visible", &Score::acc1_visible, 3});
  c.push_back ({"acc1_occluded", "the same, hidden", &Score::acc1_occluded, 3});
}

void
addMotionColumns (Columns& c)
{
  c.push_back ({"segments", "number of segments", &Score::segments, 0});
  c.push_back ({"groups", "number of motion groups", &Score::groups, 0});
  c.push_back (
      {"ari", "adjusted Rand index, motion groups against labels", &Score::ari, 3});
  c.push_back ({"purity",
                "share of points in a group that is mostly of their label",
                &Score::purity,
                3});
  c.push_back (
      {"segment_rot", "segments' rotation error, deg", &Score::segment_rot, 3});
  c.push_back ({"segment_trans",
                "segments' translation error at their centroids, mm",
                &Score::segment_trans,
                2});
  c.push_back (
      {"segment_rot_median", "its median, deg", &Score::segment_rot_median, 3});
  c.push_back (
      {"segment_trans_median", "its median, mm", &Score::segment_trans_median, 2});
  c.push_back ({"nees",
                "squared pose error of determined segments by their information; 6 is "
                "right",
                &Score::nees,
                2});
  c.push_back ({"nees_median", "its median; 5.3 is right", &Score::nees_median, 2});
  c.push_back ({"nees_groups", "the same of motion groups", &Score::nees_groups, 2});
  c.push_back ({"ause",
                "flow's reported deviation, all points with an estimate: area between "
                "the sparsification curves of it and of the errors",
                &Score::ause,
                3});
  c.push_back ({"ause_residual",
                "the same of the brightness residual (without colour the depth's)",
                &Score::ause_residual,
                3});
  c.push_back (
      {"ego_rot", "dominant motion against the camera's, deg", &Score::ego_rot, 4});
  c.push_back ({"ego_trans", "the same, mm", &Score::ego_trans, 2});
}

void
addResidualColumns (Columns& c)
{
  c.push_back ({"seen",
                "share of points with depth that the method reports visible",
                &Score::seen,
                3});
  c.push_back ({"photo_all_mean",
                "photometric residual, grey levels of 255, all points with depth",
                &Score::photo_all_mean,
                2});
  c.push_back ({"photo_all_median", "its median", &Score::photo_all_median, 2});
  c.push_back ({"photo_mean",
                "photometric residual where the first method that reports "
                "visibility sees points",
                &Score::photo_mean,
                2});
  c.push_back ({"photo_median", "its median", &Score::photo_median, 2});
  c.push_back ({"depth_mean",
                "depth residual, m, there; none for flow lifted by depth",
                &Score::depth_mean,
                4});
  c.push_back ({"depth_median", "its median, m", &Score::depth_median, 4});
  c.push_back ({"depth_sigmas",
                "median in standard deviations of the sensor's noise",
                &Score::depth_sigmas,
                2});
}

void
addRunColumns (Columns& c)
{
  c.push_back ({"converged", "1 or 0", &Score::converged, 0});
  c.push_back ({"iterations", "over all levels", &Score::iterations, 0});
  c.push_back ({"sec", "images in memory to result, s", &Score::sec, 3, true});
  c.push_back ({"sec_frame", "pyramids, normals, s", &Score::sec_frame, 3, true});
  c.push_back ({"sec_segment", "oversegmentation, s", &Score::sec_segment, 3, true});
  c.push_back ({"sec_start", "flow and proposals, s", &Score::sec_start, 3, true});
  c.push_back ({"sec_solve", "optimization, s", &Score::sec_solve, 3, true});
  c.push_back ({"sec_result", "dense result, s", &Score::sec_result, 3, true});
  c.push_back (
      {"peak_mb",
       "peak resident memory during the run, MB, with what methods before it left",
       &Score::peak_mb,
       0,
       true});
}

Columns
makeColumns ()
{
  Columns all;
  addFlowColumns (all);
  addSceneFlowColumns (all);
  addMotionColumns (all);
  addResidualColumns (all);
  addRunColumns (all);
  return all;
}

} // namespace

Score::Score()
{
  for (const Column& c : columns())
    this->*c.value = kNan;
  motion.fill (kNan);
  true_motion.fill (kNan);
}

const std::vector<Column>&
columns ()
{
  static const Columns all = makeColumns();
  return all;
}

const Column&
column (const std::string& name)
{
  for (const Column& c : columns())
    if (c.name == name)
      return c;
  throw std::out_of_range ("no column " + name);
}

} // namespace pcl_msf::tool
