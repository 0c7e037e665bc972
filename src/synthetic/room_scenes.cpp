// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_builders.h>
#include <synthetic/scene_props.h>

#include <string>

namespace pcl_msf::synthetic {
namespace {

void
addObject (SceneModel& scene, Random& random, int body, int kind)
{
  const Texture main = anyTexture (random), other = anyTexture (random);
  const double s = random.uniform (0.8, 1.2);
  switch (kind % 5) {
  case 0: // a box
    scene.addPart (body, placed (0, 0, 0), makeBox ({.22 * s, .17 * s, .15 * s}), main);
    break;
  case 1: // a planet with a ring of moons
    scene.addPart (
        body, placed (0, 0, 0), makeEllipsoid ({.2 * s, .2 * s, .2 * s}), main);
    for (int i = 0; i < 3; ++i)
      scene.addPart (
          body,
          placed (.2 * s * std::cos (2.1 * i), .2 * s * std::sin (2.1 * i), 0),
          makeEllipsoid ({.08, .08, .08}),
          other);
    break;
  case 2: // a mug
    scene.addPart (
        body, placed (0, 0, 0, {90, 0, 0}), makeCylinder (.18 * s, .14 * s), main);
    scene.addPart (body, placed (.2 * s, 0, 0), makeBox ({.07, .1 * s, .02}), other);
    break;
  case 3: // a dumb-bell
    scene.addPart (
        body, placed (-.22 * s, 0, 0, {0, 90, 0}), makeCapsule (.44 * s, .06), main);
    for (const double x : {-.22 * s, .22 * s})
      scene.addPart (body, placed (x, 0, 0), makeEllipsoid ({.1, .14, .14}), other);
    break;
  default: // a fish
    scene.addPart (
        body, placed (0, 0, 0), makeEllipsoid ({.27 * s, .15 * s, .11 * s}), main);
    scene.addPart (body, placed (.27 * s, 0, 0), makeBox ({.08, .12 * s, .02}), other);
  }
}

/** The few, faint marks of a scene that says little. */
void
makePlain (SceneModel& scene)
{
  for (Part& part : scene.parts) {
    part.texture.contrast = 0.035f;
    part.texture.finest = 0.02f;
    part.texture.pattern = Pattern::Plain;
  }
}

} // namespace

SceneModel
buildStaticRoom (Random& random)
{
  SceneModel scene;
  addRoom (scene, random);
  addFurniture (scene, random);
  scene.world_from_camera = handHeld (random, 1.3);
  return scene;
}

SceneModel
buildMultiBody (Random& random, bool plain)
{
  SceneModel scene;
  addRoom (scene, random);
  addFurniture (scene, random);
  const int first_kind = random.below (5);
  for (int i = 0; i < 5; ++i) {
    const double column = i < 3 ? -0.75 + 0.75 * i : -0.4 + 0.8 * (i - 3);
    const Isometry rest = placed (column + random.uniform (-0.08, 0.08),
                                  (i < 3 ? -0.28 : 0.38) + random.uniform (-0.06, 0.06),
                                  random.uniform (1.7, 2.2),
                                  40.0 * random.direction());
    const Motion motion = swing (rest,
                                 0.014 * random.direction(),
                                 0.03 * random.direction(),
                                 random.uniform (-0.5, 0.5));
    const int body = scene.addBody ("object_" + std::to_string (i + 1), motion);
    addObject (scene, random, body, first_kind + i);
  }
  if (plain)
    makePlain (scene);
  scene.world_from_camera = handHeld (random, 0.7);
  return scene;
}

SceneModel
buildBending (Random& random)
{
  SceneModel scene;
  addRoom (scene, random);
  addFurniture (scene, random);
  const Motion motion = swing (placed (0, -0.05, 1.75, {0, 20.0 * random.sign(), 5}),
                               0.006 * random.direction(),
                               0.01 * random.direction(),
                               0.0);
  const int body = scene.addBody ("sheet", motion, false);
  Part& part = scene.addPart (body, placed (0, 0, 0), nullptr, anyTexture (random));
  part.soft = makeBendingSheet ({0.6, 0.42}, random.uniform (-0.4, 0.4));
  part.texture.pattern = Pattern::Patches;
  scene.world_from_camera = handHeld (random, 0.5);
  return scene;
}

SceneModel
buildBreathing (Random& random)
{
  SceneModel scene;
  addRoom (scene, random);
  addFurniture (scene, random);
  const double side = random.sign();
  const Motion motion = swing (placed (0, 0.05, 1.6, {0, 10.0 * random.sign(), 0}),
                               {0.006 * side, random.uniform (-.003, .003), 0.0},
                               {random.uniform (-0.006, 0.006), 0.012 * side, 0.0},
                               0.0);
  const int body = scene.addBody ("torso", motion, false);
  Part& part = scene.addPart (body, placed (0, 0, 0), nullptr, anyTexture (random));
  part.soft = makeBreathingTorso ({0.62, 0.5}, random.uniform (-0.4, 0.4));
  part.texture.pattern = Pattern::Patches;
  scene.world_from_camera = handHeld (random, 0.3);
  return scene;
}

} // namespace pcl_msf::synthetic
