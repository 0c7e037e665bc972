// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/json.h"
#include "io/base/output_file.h"
#include "io/base/tuning_json.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/point_files.h>

#include <cmath>
#include <fstream>

namespace pcl_msf::io {

namespace {

constexpr double kDegrees = 180.0 / M_PI;

Json
vectorOf (const Eigen::Vector3d& v)
{
  return Json::array ({v.x(), v.y(), v.z()});
}

Json
matrixOf (const RigidPose& pose)
{
  const Eigen::Matrix3d r = pose.rotation();
  const Eigen::Vector3d t = pose.translation();
  Json rows = Json::array();
  for (int k = 0; k < 3; ++k)
    rows.push_back (Json::array ({r (k, 0), r (k, 1), r (k, 2), t[k]}));
  rows.push_back (Json::array ({0.0, 0.0, 0.0, 1.0}));
  return rows;
}

Json
partsOf (const CloudFlow& flow)
{
  Json parts = Json::array();
  for (const CloudPart& part : flow.parts)
    parts.push_back ({{"points", part.points},
                      {"centroid", vectorOf (part.centroid)},
                      {"target_from_source", matrixOf (part.target_from_source)}});
  return parts;
}

void
writeJson (const std::string& path, const Json& json)
{
  const std::string text = jsonText (json);
  writeBytes (path, text.data(), text.size());
}

} // namespace

void
writeJoints (const std::string& path, const CloudFlow& flow)
{
  Json joints = Json::array();
  for (const CloudJoint& joint : flow.joints)
    joints.push_back ({{"parent", joint.parent},
                       {"child", joint.child},
                       {"axis", vectorOf (joint.axis)},
                       {"angle_deg", kDegrees * joint.angle},
                       {"point", vectorOf (joint.point)},
                       {"shift", joint.shift},
                       {"axis_deviation_deg", kDegrees * joint.axis_deviation},
                       {"angle_deviation_deg", kDegrees * joint.angle_deviation},
                       {"point_deviation", joint.point_deviation}});
  Json json;
  json["joints"] = std::move (joints);
  writeJson (path, json);
}

std::vector<CloudJoint>
readJoints (const std::string& path)
{
  std::ifstream stream (path, std::ios::binary);
  const Json json = Json::parse (stream, nullptr, false);
  std::vector<CloudJoint> joints;
  try {
    for (const Json& item : json.at ("joints")) {
      CloudJoint joint;
      joint.parent = item.at ("parent").get<int>();
      joint.child = item.at ("child").get<int>();
      for (int c = 0; c < 3; ++c) {
        joint.axis[c] = item.at ("axis").at (c).get<double>();
        joint.point[c] = item.at ("point").at (c).get<double>();
      }
      joint.angle = item.at ("angle_deg").get<double>() / kDegrees;
      joint.shift = item.at ("shift").get<double>();
      joints.push_back (joint);
    }
  }
  catch (const Json::exception&) {
    throw IoError (path + ": joints: they are not as pcl_msf_register writes them");
  }
  return joints;
}

void
writeCloudReport (const std::string& path,
                  const CloudFlow& flow,
                  double load_seconds,
                  double total_seconds)
{
  const Report& report = flow.report;
  Json json{{"points", flow.warped.size()},
            {"converged", report.converged},
            {"stop_reason", toString (report.stop_reason)},
            {"message", report.message},
            {"iterations", report.iterations},
            {"explained_source", flow.explained_source},
            {"explained_target", flow.explained_target},
            {"unexplained", flow.unexplained},
            {"loose_target", flow.loose_target},
            {"self_overlap", flow.self_overlap},
            {"gap", flow.gap},
            {"bodies", flow.parts.size()},
            {"joints", flow.joints.size()}};
  json["seconds"] = {{"total", total_seconds},
                     {"load", load_seconds},
                     {"segment", report.segment_seconds},
                     {"solve", report.solve_seconds},
                     {"result", report.result_seconds}};
  json["cost"] = {{"initial", report.initial_cost.total()},
                  {"final", report.final_cost.total()}};
  json["parts"] = partsOf (flow);
  addTuning (json);
  writeJson (path, json);
}

} // namespace pcl_msf::io
