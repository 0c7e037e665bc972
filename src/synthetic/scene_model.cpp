// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_builders.h>

namespace pcl_msf {
namespace synthetic {

int
SceneModel::addBody (const std::string& name, const Motion& world_from_body, bool rigid)
{
  bodies.push_back ({name, world_from_body, rigid});
  return static_cast<int> (bodies.size()) - 1;
}

Part&
SceneModel::addPart (int body,
                     const Isometry& body_from_part,
                     const ShapePtr& shape,
                     const Texture& texture)
{
  Part part;
  part.body = body;
  part.body_from_part = body_from_part;
  part.shape = shape;
  part.texture = texture;
  parts.push_back (part);
  return parts.back();
}

SceneModel
buildScene (Scene scene, unsigned seed)
{
  Chance chance (1000003ULL * seed + static_cast<unsigned> (scene));
  switch (scene) {
  case Scene::StaticRoom:
    return buildStaticRoom (chance);
  case Scene::MultiBody:
    return buildMultiBody (chance, false);
  case Scene::Articulated:
    return buildArticulated (chance);
  case Scene::Hand:
    return buildHand (chance);
  case Scene::Bending:
    return buildBending (chance);
  case Scene::Breathing:
    return buildBreathing (chance);
  case Scene::Street:
    return buildStreet (chance);
  case Scene::TexturePoor:
    return buildMultiBody (chance, true);
  case Scene::ThinStructures:
    return buildThinStructures (chance);
  }
  return {};
}

} // namespace synthetic
} // namespace pcl_msf
