// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/json_text.h"
#include "io/base/output_file.h"
#include <pcl_msf/io/result_files.h>

#include <algorithm>
#include <vector>

namespace pcl_msf::io {

namespace {

void
addSeconds (JsonText& json, const Report& report, const RunSeconds& seconds)
{
  json.openObject ("seconds");
  json.number ("total", seconds.total);
  json.number ("load", seconds.load);
  json.number ("frame", seconds.frame);
  json.number ("segment", seconds.segment);
  json.number ("start", report.start_seconds);
  json.number ("solve", report.solve_seconds);
  json.number ("result", report.result_seconds);
  json.number ("write", seconds.write);
  json.closeObject();
}

void
addTerm (JsonText& json, const char* name, double initial, double final)
{
  json.openObject (name);
  json.number ("initial", initial);
  json.number ("final", final);
  json.closeObject();
}

void
addCost (JsonText& json, const EnergyCost& initial, const EnergyCost& final)
{
  json.openObject ("cost");
  json.number ("initial", initial.total());
  json.number ("final", final.total());
  json.openObject ("per_term");
  addTerm (json, "brightness", initial.brightness, final.brightness);
  addTerm (json, "icp", initial.icp, final.icp);
  addTerm (json, "regularizer", initial.regularizer, final.regularizer);
  addTerm (json, "prior", initial.prior, final.prior);
  addTerm (json, "concatenation", initial.concatenation, final.concatenation);
  json.closeObject();
  json.closeObject();
}

void
addHistory (JsonText& json, const std::vector<IterationRecord>& history)
{
  json.openArray ("history");
  for (const IterationRecord& record : history) {
    json.openObject();
    json.integer ("level", record.level);
    json.integer ("energy", record.energy);
    json.number ("cost", record.cost);
    json.number ("brightness", record.terms.brightness);
    json.number ("icp", record.terms.icp);
    json.number ("regularizer", record.terms.regularizer);
    json.number ("prior", record.terms.prior);
    json.number ("concatenation", record.terms.concatenation);
    json.number ("seconds", record.seconds);
    json.closeObject();
  }
  json.closeArray();
}

void
addMatrix (JsonText& json, const char* name, const Eigen::Matrix4f& matrix)
{
  json.openArray (name);
  for (int row = 0; row < 4; ++row) {
    json.openArray ("");
    for (int col = 0; col < 4; ++col)
      json.number ("", matrix (row, col));
    json.closeArray();
  }
  json.closeArray();
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
reportJson (const SceneFlow& flow, const RunSeconds& seconds, int frames)
{
  const Report& report = flow.report;
  JsonText json;
  json.openObject();
  json.integer ("frames", frames);
  json.integer ("width", flow.labels.cols);
  json.integer ("height", flow.labels.rows);
  json.integer ("segments", static_cast<long> (flow.segments.size()));
  json.integer ("undetermined_segments",
                countStatus (flow, MotionStatus::Undetermined));
  json.integer ("bodies", flow.bodies);
  json.integer ("iterations", report.iterations);
  json.boolean ("converged", report.converged);
  json.string ("stop_reason", toString (report.stop_reason));
  json.string ("message", report.message);
  addSeconds (json, report, seconds);
  addCost (json, report.initial_cost, report.final_cost);
  addHistory (json, report.history);
  addMatrix (json, "dominant_motion", flow.dominant_motion.matrix());
  json.closeObject();
  return json.text();
}

void
writeReport (const std::string& path,
             const SceneFlow& flow,
             const RunSeconds& seconds,
             int frames)
{
  const std::string text = reportJson (flow, seconds, frames);
  writeBytes (path, text.data(), text.size());
}

} // namespace pcl_msf::io
