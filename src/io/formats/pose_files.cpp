// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include "core/base/number_text.h"
#include "io/base/json.h"
#include <pcl_msf/io/pose_files.h>
#include <pcl_msf/io/text_files.h>

#include <filesystem>

namespace pcl_msf::io {

namespace {

std::string
listOf (const RigidPose& pose)
{
  std::string text = "[";
  for (int i = 0; i < 6; ++i)
    text += (i ? ", " : "") + generalText (pose.parameters[i], 17);
  return text + "]";
}

/** Places in the recording of a window's frames. */
struct Indices {
  const std::vector<int>& frames;

  int
  of (std::size_t frame) const
  {
    return frames.empty() ? static_cast<int> (frame) : frames.at (frame);
  }
};

std::string
yamlOf (const MultiframeSceneFlow& result, const Indices& index)
{
  std::string text = "%YAML:1.0\n---\n";
  text += "reference: " + std::to_string (index.of (result.reference)) + "\nframes: [";
  for (std::size_t f = 0; f < result.frames.size(); ++f)
    text += (f ? ", " : "") + std::to_string (index.of (f));
  text += "]\ndominant:\n";
  for (std::size_t f = 0; f < result.frames.size(); ++f)
    if (static_cast<int> (f) != result.reference)
      text += "  - to: " + std::to_string (index.of (f)) +
              "\n    pose: " + listOf (result.frames[f].dominant_motion) + "\n";
  text += "pairs:\n";
  for (const PairMotion& pair : result.motions) {
    text += "  - from: " + std::to_string (index.of (pair.from)) +
            "\n    to: " + std::to_string (index.of (pair.to)) + "\n    segments:\n";
    for (const RigidPose& pose : pair.segments)
      text += "      - " + listOf (pose) + "\n";
  }
  return text;
}

std::string
jsonOf (const MultiframeSceneFlow& result, const Indices& index)
{
  Json json{{"reference", index.of (result.reference)},
            {"frames", Json::array()},
            {"dominant", Json::array()},
            {"pairs", Json::array()}};
  for (std::size_t f = 0; f < result.frames.size(); ++f) {
    json["frames"].push_back (index.of (f));
    if (static_cast<int> (f) != result.reference)
      json["dominant"].push_back (
          {{"to", index.of (f)},
           {"pose", result.frames[f].dominant_motion.parameters}});
  }
  for (const PairMotion& pair : result.motions) {
    Json segments = Json::array();
    for (const RigidPose& pose : pair.segments)
      segments.push_back (pose.parameters);
    json["pairs"].push_back ({{"from", index.of (pair.from)},
                              {"to", index.of (pair.to)},
                              {"segments", segments}});
  }
  return jsonText (json);
}

} // namespace

void
writePoses (const std::string& path,
            const MultiframeSceneFlow& result,
            const std::vector<int>& frames)
{
  const bool json = std::filesystem::path (path).extension() == ".json";
  const Indices index{frames};
  writeText (path, json ? jsonOf (result, index) : yamlOf (result, index));
}

void
writeTrajectory (const std::string& path, const std::vector<TimedPose>& poses)
{
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (const TimedPose& pose : poses) {
    Eigen::Quaterniond q (Eigen::Matrix3d (pose.world_from_camera.rotation()));
    if (q.w() < 0.0)
      q.coeffs() *= -1.0;
    const Eigen::Vector3d t = pose.world_from_camera.translation();
    text += fixedText (pose.seconds, 6);
    for (const double n : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
      text += ' ' + generalText (n, 9);
    text += '\n';
  }
  writeText (path, text);
}

} // namespace pcl_msf::io
