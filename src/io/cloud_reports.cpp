// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/json_text.h"
#include "io/output_file.h"
#include <pcl_msf/io/point_files.h>

#include <cmath>

namespace pcl_msf::io {

namespace {

constexpr double kDegrees = 180.0 / M_PI;

void
addVector (JsonText& json, const char* name, const Eigen::Vector3d& v)
{
  json.openArray (name);
  for (int k = 0; k < 3; ++k)
    json.number ("", v[k]);
  json.closeArray();
}

void
addMatrix (JsonText& json, const char* name, const RigidPose& pose)
{
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = pose.rotation();
  m.topRightCorner<3, 1>() = pose.translation();
  json.openArray (name);
  for (int row = 0; row < 4; ++row) {
    json.openArray ("");
    for (int column = 0; column < 4; ++column)
      json.number ("", m (row, column));
    json.closeArray();
  }
  json.closeArray();
}

void
addParts (JsonText& json, const CloudFlow& flow)
{
  json.openArray ("parts");
  for (const CloudPart& part : flow.parts) {
    json.openObject();
    json.integer ("points", part.points);
    addVector (json, "centroid", part.centroid);
    addMatrix (json, "target_from_source", part.target_from_source);
    json.closeObject();
  }
  json.closeArray();
}

void
writeJson (const std::string& path, const JsonText& json)
{
  writeBytes (path, json.text().data(), json.text().size());
}

} // namespace

void
writeJoints (const std::string& path, const CloudFlow& flow)
{
  JsonText json;
  json.openObject();
  json.openArray ("joints");
  for (const CloudJoint& joint : flow.joints) {
    json.openObject();
    json.integer ("parent", joint.parent);
    json.integer ("child", joint.child);
    addVector (json, "axis", joint.axis);
    json.number ("angle_deg", kDegrees * joint.angle);
    addVector (json, "point", joint.point);
    json.number ("shift", joint.shift);
    json.number ("axis_deviation_deg", kDegrees * joint.axis_deviation);
    json.number ("angle_deviation_deg", kDegrees * joint.angle_deviation);
    json.number ("point_deviation", joint.point_deviation);
    json.closeObject();
  }
  json.closeArray();
  json.closeObject();
  writeJson (path, json);
}

void
writeCloudReport (const std::string& path,
                  const CloudFlow& flow,
                  double load_seconds,
                  double total_seconds)
{
  const Report& report = flow.report;
  JsonText json;
  json.openObject();
  json.integer ("points", static_cast<long> (flow.warped.size()));
  json.boolean ("converged", report.converged);
  json.string ("stop_reason", toString (report.stop_reason));
  json.string ("message", report.message);
  json.integer ("iterations", report.iterations);
  json.number ("explained_source", flow.explained_source);
  json.number ("explained_target", flow.explained_target);
  json.number ("stretch", flow.stretch);
  json.openObject ("seconds");
  json.number ("total", total_seconds);
  json.number ("load", load_seconds);
  json.number ("segment", report.segment_seconds);
  json.number ("solve", report.solve_seconds);
  json.number ("result", report.result_seconds);
  json.closeObject();
  json.openObject ("cost");
  json.number ("initial", report.initial_cost.total());
  json.number ("final", report.final_cost.total());
  json.closeObject();
  addParts (json, flow);
  json.closeObject();
  writeJson (path, json);
}

} // namespace pcl_msf::io
