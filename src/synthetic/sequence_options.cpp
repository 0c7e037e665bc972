// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_options.h>

#include <cmath>
#include <string>

namespace pcl_msf::synthetic {

const char*
toString (SceneKind scene)
{
  switch (scene) {
  case SceneKind::StaticRoom:
    return "static_room";
  case SceneKind::MultiBody:
    return "multi_body";
  case SceneKind::Articulated:
    return "articulated";
  case SceneKind::Hand:
    return "hand";
  case SceneKind::Bending:
    return "bending";
  case SceneKind::Breathing:
    return "breathing";
  case SceneKind::Street:
    return "street";
  case SceneKind::TexturePoor:
    return "texture_poor";
  case SceneKind::ThinStructures:
    return "thin_structures";
  }
  return "unknown";
}

const std::vector<SceneKind>&
allScenes ()
{
  static const std::vector<SceneKind> scenes{SceneKind::StaticRoom,
                                             SceneKind::MultiBody,
                                             SceneKind::Articulated,
                                             SceneKind::Hand,
                                             SceneKind::Bending,
                                             SceneKind::Breathing,
                                             SceneKind::Street,
                                             SceneKind::TexturePoor,
                                             SceneKind::ThinStructures};
  return scenes;
}

SceneKind
sceneFromName (const std::string& name)
{
  std::string names;
  for (const SceneKind scene : allScenes()) {
    if (name == toString (scene))
      return scene;
    names += std::string (names.empty() ? "" : ", ") + toString (scene);
  }
  throw InvalidInput ("no scene is called '" + name + "'; there are " + names);
}

bool
SequenceOptions::isValid (std::string* why) const
{
  std::string problem;
  const auto check = [&] (const char* name, double value, double low, double high) {
    if (problem.empty() && !(value >= low && value <= high))
      problem = std::string (name) + " = " + generalText (value) +
                " must lie between " + generalText (low) + " and " + generalText (high);
  };
  check ("scene", static_cast<int> (scene), 0, allScenes().size() - 1.0);
  check ("width", width, 16, 4096);
  check ("height", height, 16, 4096);
  check ("frames", frames, 1, 1000);
  check ("supersampling", supersampling, 1, 8);
  check ("motion_pixels", motion_pixels, 0, 200);
  if (problem.empty() && camera.fx != 0.0)
    camera.isValid (width, height, &problem);
  if (why)
    *why = problem;
  return problem.empty();
}

} // namespace pcl_msf::synthetic
