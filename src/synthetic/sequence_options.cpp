// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_options.h>

#include <cmath>
#include <string>

namespace pcl_msf {

const char*
toString (Scene scene)
{
  switch (scene) {
  case Scene::StaticRoom:
    return "static_room";
  case Scene::MultiBody:
    return "multi_body";
  case Scene::Articulated:
    return "articulated";
  case Scene::Hand:
    return "hand";
  case Scene::Bending:
    return "bending";
  case Scene::Breathing:
    return "breathing";
  case Scene::Street:
    return "street";
  case Scene::TexturePoor:
    return "texture_poor";
  case Scene::ThinStructures:
    return "thin_structures";
  }
  return "unknown";
}

const std::vector<Scene>&
allScenes ()
{
  static const std::vector<Scene> scenes{Scene::StaticRoom,
                                         Scene::MultiBody,
                                         Scene::Articulated,
                                         Scene::Hand,
                                         Scene::Bending,
                                         Scene::Breathing,
                                         Scene::Street,
                                         Scene::TexturePoor,
                                         Scene::ThinStructures};
  return scenes;
}

Scene
sceneFromName (const std::string& name)
{
  std::string names;
  for (const Scene scene : allScenes()) {
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

} // namespace pcl_msf
