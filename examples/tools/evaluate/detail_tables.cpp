// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/table_text.h"
#include "summary.h"
#include "tables.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl_msf::tool {

namespace {

/** A line per pair, some numbers of one method that its rows have. */
std::string
detailTable (const std::vector<Row>& rows,
             const std::string& method,
             const std::string& title,
             const std::vector<std::string>& wanted)
{
  std::vector<Column> shown;
  TableText::Line head{"pair"};
  for (const std::string& name : wanted)
    if (!valuesOf (rows, method, column (name).value).empty()) {
      shown.push_back (column (name));
      head.push_back (name);
    }
  TableText table (head);
  std::map<std::size_t, std::string> names = pairNames (rows);
  for (const Row& row : rows) {
    const bool any = std::any_of (shown.begin(), shown.end(), [&] (const Column& c) {
      return std::isfinite (row.score.*c.value);
    });
    if (row.method != method || !any)
      continue;
    TableText::Line line{names[row.pair]};
    for (const Column& c : shown)
      line.push_back (cell (row.score.*c.value, c.decimals));
    table.add (line);
  }
  if (table.empty())
    return {};
  return title + ", " + method + "\n\n" + table.text() + "\n";
}

} // namespace

std::string
detailTables (const std::vector<Row>& rows, const std::string& method)
{
  return detailTable (rows,
                      method,
                      "Flow, px",
                      {"coverage",
                       "epe_all",
                       "epe_visible",
                       "epe_occluded",
                       "epe_median",
                       "rms_visible",
                       "aae_visible",
                       "out_all",
                       "out_visible",
                       "out_occluded"}) +
         detailTable (rows,
                      method,
                      "Scene flow, m",
                      {"epe3d_all",
                       "epe3d_visible",
                       "epe3d_occluded",
                       "epe3d_median",
                       "acc5_visible",
                       "acc1_visible"}) +
         detailTable (rows,
                      method,
                      "Segments and motions, deg and mm",
                      {"segments",
                       "groups",
                       "ari",
                       "purity",
                       "segment_rot",
                       "segment_trans",
                       "segment_rot_median",
                       "segment_trans_median",
                       "ego_rot",
                       "ego_trans"}) +
         detailTable (rows,
                      method,
                      "Residuals, grey levels and m; time, s; memory, MB",
                      {"seen",
                       "photo_mean",
                       "photo_median",
                       "depth_mean",
                       "depth_median",
                       "depth_sigmas",
                       "sec",
                       "sec_frame",
                       "sec_segment",
                       "sec_start",
                       "sec_solve",
                       "sec_result",
                       "peak_mb"});
}

} // namespace pcl_msf::tool
