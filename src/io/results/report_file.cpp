// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/order_statistics.h"
#include "io/base/json.h"
#include "io/base/output_file.h"
#include "io/base/tuning_json.h"
#include <pcl_msf/io/result_files.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pcl_msf::io {

namespace {

Json
secondsOf (const Report& report, const RunSeconds& seconds)
{
  return {{"total", seconds.total},
          {"load", seconds.load},
          {"frame", seconds.frame},
          {"segment", seconds.segment},
          {"start", report.start_seconds},
          {"solve", report.solve_seconds},
          {"result", report.result_seconds},
          {"write", seconds.write}};
}

Json
changeOf (double initial, double final)
{
  return {{"initial", initial}, {"final", final}};
}

Json
costOf (const EnergyCost& initial, const EnergyCost& final)
{
  Json cost = changeOf (initial.total(), final.total());
  cost["per_term"] = {
      {"brightness", changeOf (initial.brightness, final.brightness)},
      {"icp", changeOf (initial.icp, final.icp)},
      {"regularizer", changeOf (initial.regularizer, final.regularizer)},
      {"prior", changeOf (initial.prior, final.prior)},
      {"concatenation", changeOf (initial.concatenation, final.concatenation)}};
  return cost;
}

Json
historyOf (const std::vector<IterationRecord>& records)
{
  Json history = Json::array();
  for (const IterationRecord& record : records)
    history.push_back ({{"level", record.level},
                        {"energy", record.energy},
                        {"cost", record.cost},
                        {"brightness", record.terms.brightness},
                        {"icp", record.terms.icp},
                        {"regularizer", record.terms.regularizer},
                        {"prior", record.terms.prior},
                        {"concatenation", record.terms.concatenation},
                        {"flow", record.terms.flow},
                        {"seconds", record.seconds}});
  return history;
}

Json
rowsOf (const Eigen::Matrix4f& matrix)
{
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row)
    rows.push_back (
        {matrix (row, 0), matrix (row, 1), matrix (row, 2), matrix (row, 3)});
  return rows;
}

Json
cameraOf (const PinholeCamera& camera, const LensDistortion& removed)
{
  Json json = {
      {"fx", camera.fx}, {"fy", camera.fy}, {"cx", camera.cx}, {"cy", camera.cy}};
  if (!removed.isNone())
    json["removed_distortion"] = {{"k1", removed.k1},
                                  {"k2", removed.k2},
                                  {"p1", removed.p1},
                                  {"p2", removed.p2},
                                  {"k3", removed.k3}};
  return json;
}

/** Six rows; of zeros when nothing is known. */
Json
rowsOf (const Matrix6& matrix)
{
  Json rows = Json::array();
  for (int row = 0; row < 6; ++row) {
    rows.push_back (Json::array());
    for (int col = 0; col < 6; ++col)
      rows.back().push_back (matrix (row, col));
  }
  return rows;
}

/** Middle of the values that are known; 0 for none. */
double
medianOf (const cv::Mat& image)
{
  std::vector<float> values;
  values.reserve (image.total());
  for (int row = 0; row < image.rows; ++row)
    std::copy_if (image.ptr<float> (row),
                  image.ptr<float> (row) + image.cols,
                  std::back_inserter (values),
                  [] (float value) { return std::isfinite (value); });
  return values.empty() ? 0.0 : median (values);
}

/** What is known of the errors; nothing of results that don't tell. */
void
addConfidence (const SceneFlow& flow, Json& json)
{
  const double pixels = medianOf (flow.flow_deviation);
  const double metres = medianOf (flow.displacement_deviation);
  if (pixels > 0.0)
    json["median_flow_deviation_px"] = pixels;
  if (metres > 0.0)
    json["median_displacement_deviation_m"] = metres;
  const bool has_group =
      flow.dominant_group >= 0 &&
      flow.dominant_group < static_cast<int> (flow.group_motions.size());
  if (has_group && flow.group_motions[flow.dominant_group].information.allFinite())
    json["dominant_motion_information"] =
        rowsOf (flow.group_motions[flow.dominant_group].information);
}

long
countStatus (const SceneFlow& flow, MotionStatus status)
{
  return std::count_if (flow.segments.begin(), flow.segments.end(), [status] (auto& s) {
    return s.status == status;
  });
}

} // namespace

std::string
reportJson (const SceneFlow& flow,
            const RunSeconds& seconds,
            int frames,
            const LensDistortion& removed)
{
  const Report& report = flow.report;
  Json json{{"frames", frames},
            {"width", flow.labels.cols},
            {"height", flow.labels.rows},
            {"camera", cameraOf (flow.camera, removed)},
            {"segments", flow.segments.size()},
            {"undetermined_segments", countStatus (flow, MotionStatus::Undetermined)},
            {"bodies", flow.groups},
            {"iterations", report.iterations},
            {"light_changed", report.light_changed},
            {"converged", report.converged},
            {"stop_reason", toString (report.stop_reason)},
            {"message", report.message},
            {"seconds", secondsOf (report, seconds)},
            {"cost", costOf (report.initial_cost, report.final_cost)},
            {"history", historyOf (report.history)},
            {"dominant_motion", rowsOf (flow.dominant_motion.matrix())}};
  addConfidence (flow, json);
  addTuning (json);
  return jsonText (json);
}

void
writeReport (const std::string& path,
             const SceneFlow& flow,
             const RunSeconds& seconds,
             int frames,
             const LensDistortion& removed)
{
  const std::string text = reportJson (flow, seconds, frames, removed);
  writeBytes (path, text.data(), text.size());
}

} // namespace pcl_msf::io
