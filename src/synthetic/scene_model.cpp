// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_builders.h>

namespace pcl_msf::synthetic {

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
buildScene (SceneKind scene, unsigned seed)
{
  Random random (1000003ULL * seed + static_cast<unsigned> (scene));
  switch (scene) {
  case SceneKind::StaticRoom:
    return buildStaticRoom (random);
  case SceneKind::MultiBody:
    return buildMultiBody (random, false);
  case SceneKind::Articulated:
    return buildArticulated (random);
  case SceneKind::Hand:
    return buildHand (random);
  case SceneKind::Bending:
    return buildBending (random);
  case SceneKind::Breathing:
    return buildBreathing (random);
  case SceneKind::Street:
    return buildStreet (random);
  case SceneKind::TexturePoor:
    return buildMultiBody (random, true);
  case SceneKind::ThinStructures:
    return buildThinStructures (random);
  }
  return {};
}

} // namespace pcl_msf::synthetic
