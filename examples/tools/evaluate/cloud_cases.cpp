// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "cloud_cases.h"

#include <pcl_msf/errors.h>
#include <pcl_msf/io/point_files.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <algorithm>
#include <filesystem>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

constexpr double kAngles[] = {10.0, 30.0}; // degrees, of the joints
constexpr int kPoints = 12000;
constexpr double kNoise = 0.001;

/** A generated body and its name, "hand_30_2": joints' angle and seed. */
struct NamedBody {
  std::string name;
  synthetic::BodyOptions options;
};

std::vector<NamedBody>
bodiesOf (const GeneratedOptions& generated)
{
  std::vector<NamedBody> bodies;
  for (int k = 0; k < generated.noise_seeds; ++k)
    for (const synthetic::BodyKind kind : synthetic::allBodies())
      for (const double angle : kAngles) {
        NamedBody body;
        body.options.body = kind;
        body.options.points = kPoints;
        body.options.noise = kNoise;
        body.options.angle = angle;
        body.options.seed = static_cast<unsigned> (generated.seed) + k;
        body.name = std::string (toString (kind)) + "_" +
                    std::to_string (static_cast<int> (angle)) + "_" +
                    std::to_string (body.options.seed);
        bodies.push_back (body);
      }
  return bodies;
}

bool
isCase (const fs::path& folder)
{
  return fs::exists (folder / "source.ply") && fs::exists (folder / "target.ply") &&
         fs::exists (folder / "truth.ply");
}

} // namespace

std::vector<std::string>
listCloudCases (const EvaluateOptions& options)
{
  std::vector<std::string> names;
  if (options.dataset == kBodies) {
    for (const NamedBody& body : bodiesOf (options.generated))
      names.push_back (body.name);
    return names;
  }
  if (isCase (options.path))
    names.emplace_back (".");
  std::error_code error;
  for (const auto& entry : fs::directory_iterator (options.path, error))
    if (isCase (entry.path()))
      names.push_back (entry.path().filename().string());
  std::sort (names.begin(), names.end());
  if (names.empty())
    throw UsageError (options.path + ": no folder with source.ply, target.ply and "
                                     "truth.ply; pcl_msf_synthesize makes some");
  return names;
}

CloudCase
loadCloudCase (const EvaluateOptions& options, const std::string& name)
{
  if (options.dataset == kBodies)
    for (const NamedBody& body : bodiesOf (options.generated))
      if (body.name == name) {
        synthetic::BodyClouds clouds = synthetic::synthesizeBody (body.options);
        return {std::move (clouds.source),
                std::move (clouds.target),
                std::move (clouds.truth)};
      }
  const fs::path folder = fs::path (options.path) / name;
  CloudCase data;
  data.source = io::readPoints ((folder / "source.ply").string()).points;
  data.target = io::readPoints ((folder / "target.ply").string()).points;
  data.truth = io::readPoints ((folder / "truth.ply").string()).points;
  if (data.truth.size() != data.source.size())
    throw IoError ((folder / "truth.ply").string() + ": points: there are " +
                   std::to_string (data.truth.size()) + ", the source has " +
                   std::to_string (data.source.size()));
  return data;
}

} // namespace pcl_msf::tool
