// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/synthetic/sequence_options.h>
#include <synthetic/isometry.h>
#include <synthetic/shape.h>
#include <synthetic/soft_surface.h>
#include <synthetic/texture.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief A pose as a function of the scene's phase; phase 0 = frame 0. */
using Motion = std::function<Isometry (double phase)>;

/** \brief Something that has one label and one motion. */
struct Body {
  std::string name;
  Motion world_from_body;
  bool rigid{true};
};

/** \brief A piece of a body's surface: a rigid shape, or a soft surface. */
struct Part {
  int body{0};
  Isometry body_from_part{Isometry::Identity()};
  ShapePtr shape;
  SoftSurfacePtr soft; ///< when this is set, shape is not
  Texture texture;
};

/** \brief A scene: y down, z forward from the first camera, metres. The scene's phase
 * says how far its motion is; frame k has phase k times a rate. Immutable when built.
 */
struct SceneModel {
  std::vector<Body> bodies; ///< 0 = static
  std::vector<Part> parts;
  Motion world_from_camera;
  Eigen::Vector3d light{0.35, -0.8, -0.5}; ///< towards the light, world, at phase 0
  bool sky{false};                         ///< draw a sky where nothing is hit

  int
  addBody (const std::string& name, const Motion& world_from_body, bool rigid = true);

  Part&
  addPart (int body,
           const Isometry& body_from_part,
           const ShapePtr& shape,
           const Texture& texture);
};

/** \brief The scene of a name and a seed. */
SceneModel
buildScene (SceneKind scene, unsigned seed);

} // namespace pcl_msf::synthetic
