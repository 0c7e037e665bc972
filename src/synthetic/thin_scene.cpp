// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/flatten.h"
#include <synthetic/scene_builders.h>
#include <synthetic/scene_props.h>

#include <string>

namespace pcl_msf::synthetic {
namespace {

PCL_MSF_FLATTEN void // so that none of Eigen's functions for aligned types is left
addRod (SceneModel& scene,
        Random& random,
        int body,
        const Eigen::Vector3d& from,
        const Eigen::Vector3d& to,
        double radius)
{
  Isometry pose = Isometry::Identity();
  const Eigen::Vector3d axis = to - from;
  pose.linear() = Eigen::Quaterniond::FromTwoVectors (Eigen::Vector3d::UnitZ(), axis)
                      .toRotationMatrix();
  pose.translation() = from;
  scene.addPart (body, pose, makeCapsule (axis.norm(), radius), anyTexture (random));
}

/** The edges of a box. */
void
addFrame (
    SceneModel& scene, Random& random, int body, const Eigen::Vector3d& half, double r)
{
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 4; ++corner) {
      Eigen::Vector3d from = -half;
      from[(axis + 1) % 3] *= corner % 2 ? -1.0 : 1.0;
      from[(axis + 2) % 3] *= corner / 2 ? -1.0 : 1.0;
      Eigen::Vector3d to = from;
      to[axis] = half[axis];
      addRod (scene, random, body, from, to, r);
    }
}

void
addLadder (SceneModel& scene, Random& random, int body)
{
  for (const double x : {-0.16, 0.16})
    addRod (scene, random, body, {x, -0.5, 0}, {x, 0.5, 0}, 0.014);
  for (int i = 0; i < 7; ++i) {
    const double y = -0.42 + 0.14 * i;
    addRod (scene, random, body, {-0.16, y, 0}, {0.16, y, 0}, 0.009);
  }
}

} // namespace

SceneModel
buildThinStructures (Random& random)
{
  SceneModel scene;
  addRoom (scene, random, 3.8);
  addFurniture (scene, random);
  // A fence and wires stand still.
  for (int i = 0; i < 9; ++i) {
    const double x = -1.3 + 0.32 * i;
    addRod (scene, random, 0, {x, 0.35, 2.3}, {x, 1.2, 2.3}, 0.012);
  }
  for (const double y : {0.45, 0.8})
    addRod (scene, random, 0, {-1.4, y, 2.33}, {1.4, y, 2.33}, 0.01);
  for (int i = 0; i < 3; ++i)
    addRod (scene,
            random,
            0,
            {-1.5, -0.75 + 0.1 * i, 1.9},
            {1.5, -0.65 + 0.05 * i, 1.9},
            0.006);
  const Isometry rests[] = {placed (-0.6, -0.1, 1.6, {20, 30, 5}),
                            placed (0.05, 0.0, 1.7, {5, 25, 12}),
                            placed (0.65, -0.1, 1.6, {10, -25, -15})};
  for (int i = 0; i < 3; ++i) {
    const int body = scene.addBody ("thin_" + std::to_string (i + 1),
                                    swing (rests[i],
                                           0.012 * random.direction(),
                                           0.025 * random.direction(),
                                           random.uniform (-0.5, 0.5)));
    if (i == 0)
      addFrame (scene, random, body, {0.2, 0.3, 0.15}, 0.012);
    else if (i == 1)
      addLadder (scene, random, body);
    else // a board with a thin edge, and a rod through it
      scene.addPart (
          body, placed (0, 0, 0), makeBox ({0.01, 0.35, 0.2}), anyTexture (random));
    if (i == 2)
      addRod (scene, random, body, {-0.25, 0, 0}, {0.25, 0, 0}, 0.015);
  }
  scene.world_from_camera = handHeld (random, 0.6);
  return scene;
}

} // namespace pcl_msf::synthetic
