// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_builders.h>
#include <synthetic/scene_props.h>

#include <string>

namespace pcl_msf::synthetic {
namespace {

void
addObject (SceneModel& scene, Chance& chance, int body, int kind)
{
  const Texture main = anyTexture (chance), other = anyTexture (chance);
  const double s = chance.uniform (0.8, 1.2);
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
buildStaticRoom (Chance& chance)
{
  SceneModel scene;
  addRoom (scene, chance);
  addFurniture (scene, chance);
  scene.world_from_camera = handHeld (chance, 1.3);
  return scene;
}

SceneModel
buildMultiBody (Chance& chance, bool plain)
{
  SceneModel scene;
  addRoom (scene, chance);
  addFurniture (scene, chance);
  const int first_kind = chance.below (5);
  for (int i = 0; i < 5; ++i) {
    const double column = i < 3 ? -0.75 + 0.75 * i : -0.4 + 0.8 * (i - 3);
    const Isometry rest = placed (column + chance.uniform (-0.08, 0.08),
                                  (i < 3 ? -0.28 : 0.38) + chance.uniform (-0.06, 0.06),
                                  chance.uniform (1.7, 2.2),
                                  40.0 * chance.direction());
    const Motion motion = swing (rest,
                                 0.014 * chance.direction(),
                                 0.03 * chance.direction(),
                                 chance.uniform (-0.5, 0.5));
    const int body = scene.addBody ("object_" + std::to_string (i + 1), motion);
    addObject (scene, chance, body, first_kind + i);
  }
  if (plain)
    makePlain (scene);
  scene.world_from_camera = handHeld (chance, 0.7);
  return scene;
}

SceneModel
buildBending (Chance& chance)
{
  SceneModel scene;
  addRoom (scene, chance);
  addFurniture (scene, chance);
  const Motion motion = swing (placed (0, -0.05, 1.75, {0, 20.0 * chance.sign(), 5}),
                               0.006 * chance.direction(),
                               0.01 * chance.direction(),
                               0.0);
  const int body = scene.addBody ("sheet", motion, false);
  Part& part = scene.addPart (body, placed (0, 0, 0), nullptr, anyTexture (chance));
  part.soft = makeBendingSheet ({0.6, 0.42}, chance.uniform (-0.4, 0.4));
  part.texture.pattern = Pattern::Patches;
  scene.world_from_camera = handHeld (chance, 0.5);
  return scene;
}

SceneModel
buildBreathing (Chance& chance)
{
  SceneModel scene;
  addRoom (scene, chance);
  addFurniture (scene, chance);
  const double side = chance.sign();
  const Motion motion = swing (placed (0, 0.05, 1.6, {0, 10.0 * chance.sign(), 0}),
                               {0.006 * side, chance.uniform (-.003, .003), 0.0},
                               {chance.uniform (-0.006, 0.006), 0.012 * side, 0.0},
                               0.0);
  const int body = scene.addBody ("torso", motion, false);
  Part& part = scene.addPart (body, placed (0, 0, 0), nullptr, anyTexture (chance));
  part.soft = makeBreathingTorso ({0.62, 0.5}, chance.uniform (-0.4, 0.4));
  part.texture.pattern = Pattern::Patches;
  scene.world_from_camera = handHeld (chance, 0.3);
  return scene;
}

} // namespace pcl_msf::synthetic
