// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_builders.h>
#include <synthetic/scene_props.h>

#include <string>

namespace pcl_msf::synthetic {
namespace {

constexpr double ground = 1.6; ///< metres below the camera

void
addCar (SceneModel& scene, Chance& chance, int body)
{
  Texture paint = anyTexture (chance);
  paint.pattern = Pattern::Plain;
  paint.contrast = 0.12f;
  const Texture glass = texture (chance, {70, 60, 50});
  const Texture rubber = texture (chance, {40, 40, 42});
  scene.addPart (body, placed (0, -0.65, 0), makeBox ({0.88, 0.35, 2.1}), paint);
  scene.addPart (body, placed (0, -1.2, 0.2), makeBox ({0.78, 0.26, 1.15}), glass);
  scene.addPart (body, placed (0, -1.48, 0.2), makeBox ({0.74, 0.03, 1.05}), paint);
  for (const double x : {-0.85, 0.85})
    for (const double z : {-1.35, 1.35})
      scene.addPart (
          body, placed (x, -0.33, z, {0, 90, 0}), makeCylinder (0.12, 0.33), rubber);
}

void
addHouses (SceneModel& scene, Chance& chance)
{
  for (const double side : {-1.0, 1.0})
    for (double z = chance.uniform (4.0, 8.0); z < 76.0;) {
      const double length = chance.uniform (5.0, 9.0);
      const double height = chance.uniform (2.5, 6.5);
      Texture front = anyTexture (chance);
      front.color = 0.5f * front.color + Eigen::Vector3f (75.0f, 80.0f, 85.0f);
      front.pattern = Pattern::Tiles;
      front.pattern_size = static_cast<float> (chance.uniform (1.2, 2.2));
      front.coarsest = 4.0f;
      scene.addPart (
          0,
          placed (side * chance.uniform (11.0, 12.5), ground - height, z + length),
          makeBox ({4.0, height, length}),
          front);
      z += 2.0 * length + chance.uniform (0.5, 3.0);
    }
}

void
addTrees (SceneModel& scene, Chance& chance)
{
  for (const double side : {-1.0, 1.0})
    for (double z = 9.0; z < 70.0; z += chance.uniform (9.0, 14.0)) {
      const double x = side * chance.uniform (5.6, 6.2);
      scene.addPart (0,
                     placed (x, ground - 1.3, z, {90, 0, 0}),
                     makeCylinder (1.3, 0.13),
                     texture (chance, {50, 70, 95}));
      Texture leaves =
          texture (chance, {60, 120, 80}, Pattern::Patches, {35, 80, 50}, 0.35f);
      leaves.contrast = 0.4f;
      scene.addPart (
          0, placed (x, ground - 3.4, z), makeEllipsoid ({1.1, 1.3, 1.1}), leaves);
    }
}

} // namespace

SceneModel
buildStreet (Chance& chance)
{
  SceneModel scene;
  scene.sky = true;
  scene.addBody ("static", atRest());
  Texture asphalt = texture (chance, {105, 105, 108});
  asphalt.coarsest = 12.0f;
  scene.addPart (0, placed (0, ground + 0.1, 30), makeBox ({60, 0.1, 50}), asphalt);
  for (const double x : {-1.75, 1.75})
    for (int i = 0; i < 12; ++i)
      scene.addPart (0,
                     placed (x, ground, 4.0 + 6.0 * i),
                     makeBox ({0.08, 0.012, 1.2}),
                     texture (chance, {215, 220, 222}));
  Texture curb =
      texture (chance, {140, 145, 150}, Pattern::Tiles, {100, 100, 105}, 1.f);
  curb.coarsest = 6.0f;
  for (const double side : {-1.0, 1.0})
    scene.addPart (
        0, placed (side * 6.5, ground - 0.05, 30), makeBox ({1.6, 0.1, 50}), curb);
  addHouses (scene, chance);
  addTrees (scene, chance);
  const double lanes[] = {-3.4, 0.0, 3.4, -3.4, 0.0, 3.4};
  for (int i = 0; i < 6; ++i) {
    const double z = 7.5 + 4.2 * i + chance.uniform (-0.6, 0.6);
    const double speed = (lanes[i] < -1.0 ? -1.0 : 1.0) * chance.uniform (0.05, 0.12);
    const Motion motion = swing (placed (lanes[i], ground, z),
                                 {chance.uniform (-0.008, 0.008), 0.0, speed},
                                 {0.0, chance.uniform (-0.004, 0.004), 0.0},
                                 chance.uniform (-0.3, 0.3));
    addCar (scene, chance, scene.addBody ("car_" + std::to_string (i + 1), motion));
  }
  scene.world_from_camera = swing (Isometry::Identity(),
                                   {chance.uniform (-0.02, 0.02), 0.002, 0.16},
                                   0.0015 * chance.direction(),
                                   chance.uniform (-0.2, 0.2));
  return scene;
}

} // namespace pcl_msf::synthetic
