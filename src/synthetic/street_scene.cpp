// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_builders.h>
#include <synthetic/scene_props.h>

#include <string>

namespace pcl_msf::synthetic {
namespace {

constexpr double ground = 1.6; ///< metres below the camera

void
addCar (SceneModel& scene, Random& random, int body)
{
  Texture paint = anyTexture (random);
  paint.pattern = Pattern::Plain;
  paint.contrast = 0.12f;
  const Texture glass = texture (random, {70, 60, 50});
  const Texture rubber = texture (random, {40, 40, 42});
  scene.addPart (body, placed (0, -0.65, 0), makeBox ({0.88, 0.35, 2.1}), paint);
  scene.addPart (body, placed (0, -1.2, 0.2), makeBox ({0.78, 0.26, 1.15}), glass);
  scene.addPart (body, placed (0, -1.48, 0.2), makeBox ({0.74, 0.03, 1.05}), paint);
  for (const double x : {-0.85, 0.85})
    for (const double z : {-1.35, 1.35})
      scene.addPart (
          body, placed (x, -0.33, z, {0, 90, 0}), makeCylinder (0.12, 0.33), rubber);
}

void
addHouses (SceneModel& scene, Random& random)
{
  for (const double side : {-1.0, 1.0})
    for (double z = random.uniform (4.0, 8.0); z < 76.0;) {
      const double length = random.uniform (5.0, 9.0);
      const double height = random.uniform (2.5, 6.5);
      Texture front = anyTexture (random);
      front.color = 0.5f * front.color + Eigen::Vector3f (75.0f, 80.0f, 85.0f);
      front.pattern = Pattern::Tiles;
      front.pattern_size = static_cast<float> (random.uniform (1.2, 2.2));
      front.coarsest = 4.0f;
      scene.addPart (
          0,
          placed (side * random.uniform (11.0, 12.5), ground - height, z + length),
          makeBox ({4.0, height, length}),
          front);
      z += 2.0 * length + random.uniform (0.5, 3.0);
    }
}

void
addTrees (SceneModel& scene, Random& random)
{
  for (const double side : {-1.0, 1.0})
    for (double z = 9.0; z < 70.0; z += random.uniform (9.0, 14.0)) {
      const double x = side * random.uniform (5.6, 6.2);
      scene.addPart (0,
                     placed (x, ground - 1.3, z, {90, 0, 0}),
                     makeCylinder (1.3, 0.13),
                     texture (random, {50, 70, 95}));
      Texture leaves =
          texture (random, {60, 120, 80}, Pattern::Patches, {35, 80, 50}, 0.35f);
      leaves.contrast = 0.4f;
      scene.addPart (
          0, placed (x, ground - 3.4, z), makeEllipsoid ({1.1, 1.3, 1.1}), leaves);
    }
}

} // namespace

SceneModel
buildStreet (Random& random)
{
  SceneModel scene;
  scene.sky = true;
  scene.addBody ("static", atRest());
  Texture asphalt = texture (random, {105, 105, 108});
  asphalt.coarsest = 12.0f;
  scene.addPart (0, placed (0, ground + 0.1, 30), makeBox ({60, 0.1, 50}), asphalt);
  for (const double x : {-1.75, 1.75})
    for (int i = 0; i < 12; ++i)
      scene.addPart (0,
                     placed (x, ground, 4.0 + 6.0 * i),
                     makeBox ({0.08, 0.012, 1.2}),
                     texture (random, {215, 220, 222}));
  Texture curb =
      texture (random, {140, 145, 150}, Pattern::Tiles, {100, 100, 105}, 1.f);
  curb.coarsest = 6.0f;
  for (const double side : {-1.0, 1.0})
    scene.addPart (
        0, placed (side * 6.5, ground - 0.05, 30), makeBox ({1.6, 0.1, 50}), curb);
  addHouses (scene, random);
  addTrees (scene, random);
  const double lanes[] = {-3.4, 0.0, 3.4, -3.4, 0.0, 3.4};
  for (int i = 0; i < 6; ++i) {
    const double z = 7.5 + 4.2 * i + random.uniform (-0.6, 0.6);
    const double speed = (lanes[i] < -1.0 ? -1.0 : 1.0) * random.uniform (0.05, 0.12);
    const Motion motion = swing (placed (lanes[i], ground, z),
                                 {random.uniform (-0.008, 0.008), 0.0, speed},
                                 {0.0, random.uniform (-0.004, 0.004), 0.0},
                                 random.uniform (-0.3, 0.3));
    addCar (scene, random, scene.addBody ("car_" + std::to_string (i + 1), motion));
  }
  scene.world_from_camera = swing (Isometry::Identity(),
                                   {random.uniform (-0.02, 0.02), 0.002, 0.16},
                                   0.0015 * random.direction(),
                                   random.uniform (-0.2, 0.2));
  return scene;
}

} // namespace pcl_msf::synthetic
