// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_props.h>

#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr double frequency = 0.06; ///< radians per phase

Eigen::Matrix3d
turned (const Eigen::Vector3d& rotation_vector)
{
  const double angle = rotation_vector.norm();
  if (angle == 0.0)
    return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd (angle, rotation_vector / angle).toRotationMatrix();
}

const Eigen::Vector3f palette[] = {{60, 70, 190},
                                   {70, 150, 70},
                                   {180, 110, 60},
                                   {60, 170, 205},
                                   {150, 80, 140},
                                   {160, 160, 80},
                                   {90, 120, 180},
                                   {170, 170, 165}};

} // namespace

Isometry
placed (double x, double y, double z, const Eigen::Vector3d& turn_degrees)
{
  Isometry pose = Isometry::Identity();
  pose.linear() = turned (turn_degrees * M_PI / 180.0);
  pose.translation() = Eigen::Vector3d (x, y, z);
  return pose;
}

double
swingAt (double phase, double start)
{
  return (std::sin (frequency * phase + start) - std::sin (start)) /
         (frequency * std::cos (start));
}

Motion
swing (const Isometry& at_rest,
       const Eigen::Vector3d& speed,
       const Eigen::Vector3d& turn,
       double start)
{
  return [=] (double phase) {
    const double way = swingAt (phase, start);
    Isometry pose = Isometry::Identity();
    pose.linear() = turned (way * turn) * at_rest.linear();
    pose.translation() = at_rest.translation() + way * speed;
    return pose;
  };
}

Motion
atRest ()
{
  return [] (double) { return Isometry::Identity(); };
}

Motion
handHeld (Random& random, double strength)
{
  // Going right and turning right both move the image to the left.
  const double side = random.sign();
  const Eigen::Vector3d speed = 0.011 * strength *
                                Eigen::Vector3d (side * random.uniform (0.5, 1.0),
                                                 random.uniform (-0.4, 0.4),
                                                 random.uniform (-0.8, 0.8));
  const Eigen::Vector3d turn = 0.0035 * strength *
                               Eigen::Vector3d (random.uniform (-0.6, 0.6),
                                                side * random.uniform (0.3, 1.0),
                                                random.uniform (-0.8, 0.8));
  return swing (Isometry::Identity(), speed, turn, random.uniform (-0.5, 0.5));
}

Texture
texture (Random& random,
         const Eigen::Vector3f& bgr,
         Pattern pattern,
         const Eigen::Vector3f& second,
         float pattern_size)
{
  Texture result;
  result.color = bgr;
  result.second = second;
  result.pattern = pattern;
  result.pattern_size = pattern_size;
  for (int a = 0; a < 3; ++a)
    result.offset[a] = static_cast<float> (random.uniform (-20.0, 20.0));
  return result;
}

Texture
anyTexture (Random& random)
{
  constexpr int colors = sizeof palette / sizeof palette[0];
  const Eigen::Vector3f first = palette[random.below (colors)];
  const Eigen::Vector3f second = palette[random.below (colors)] * 0.75f;
  const Pattern patterns[] = {
      Pattern::Plain, Pattern::Patches, Pattern::Tiles, Pattern::Stripes};
  const Pattern pattern = patterns[random.below (4)];
  const float size = static_cast<float> (random.uniform (0.06, 0.16));
  return texture (random, first, pattern, second, size);
}

void
addRoom (SceneModel& scene, Random& random, double back)
{
  const int room = scene.addBody ("static", atRest());
  const Texture wall =
      texture (random, {175, 190, 200}, Pattern::Stripes, {160, 178, 192}, 0.6f);
  const double front = -1.6, middle = 0.5 * (front + back);
  const double depth = 0.5 * (back - front);
  scene.addPart (room, placed (0, -0.15, middle), makeRoom ({2.8, 1.35, depth}), wall);
  const Texture planks =
      texture (random, {85, 125, 165}, Pattern::Tiles, {40, 65, 90}, 0.45f);
  scene.addPart (
      room, placed (0, 1.2, middle), makeBox ({2.79, 0.005, depth - 0.01}), planks);
  // Pictures on the back wall.
  for (int i = 0; i < 3; ++i) {
    const double x = -1.7 + 1.6 * i + random.uniform (-0.2, 0.2);
    const double y = random.uniform (-0.7, -0.3);
    const Eigen::Vector3d half (
        random.uniform (0.25, 0.5), random.uniform (0.2, 0.35), 0.02);
    scene.addPart (room,
                   placed (x, y, back - 0.02),
                   makeBox (half + Eigen::Vector3d (0.03, 0.03, -0.005)),
                   texture (random, {45, 50, 60}));
    scene.addPart (
        room, placed (x, y, back - 0.03), makeBox (half), anyTexture (random));
  }
}

void
addFurniture (SceneModel& scene, Random& random)
{
  const double side = random.sign();
  const Texture wood =
      texture (random, {70, 110, 160}, Pattern::Patches, {60, 95, 140}, 0.08f);
  const double x = 0.9 * side, z = random.uniform (2.7, 3.1);
  scene.addPart (0, placed (x, 0.45, z), makeBox ({0.7, 0.025, 0.4}), wood);
  for (int leg = 0; leg < 4; ++leg)
    scene.addPart (
        0,
        placed (x + (leg % 2 ? 0.62 : -0.62), 0.82, z + (leg / 2 ? .32 : -.32)),
        makeBox ({0.035, 0.36, 0.035}),
        wood);
  scene.addPart (0,
                 placed (x - 0.25, 0.28, z, {0, random.uniform (-40, 40), 0}),
                 makeBox ({0.16, 0.145, 0.12}),
                 anyTexture (random));
  scene.addPart (0,
                 placed (x + 0.3, 0.27, z - 0.05),
                 makeEllipsoid ({0.16, 0.155, 0.16}),
                 anyTexture (random));
  // A shelf, a ball, a lamp and boxes on the other side.
  const double sx = -1.5 * side;
  scene.addPart (0, placed (sx, 0.35, 4.0), makeBox ({0.5, 0.84, 0.2}), wood);
  for (int shelf = 0; shelf < 3; ++shelf)
    scene.addPart (0,
                   placed (sx, -0.2 + 0.5 * shelf, 3.85),
                   makeBox ({0.43, 0.19, 0.12}),
                   anyTexture (random));
  scene.addPart (0,
                 placed (-0.75 * side, 0.93, 3.0),
                 makeEllipsoid ({0.26, 0.26, 0.26}),
                 anyTexture (random));
  scene.addPart (0,
                 placed (-1.7 * side, 0.85, 2.6, {0, random.uniform (-40, 40), 0}),
                 makeBox ({0.3, 0.34, 0.3}),
                 anyTexture (random));
  scene.addPart (0,
                 placed (2.1 * side, 0.4, 3.9, {90, 0, 0}),
                 makeCylinder (0.8, 0.04),
                 texture (random, {60, 60, 60}));
  scene.addPart (0,
                 placed (2.1 * side, -0.5, 3.9),
                 makeEllipsoid ({0.24, 0.2, 0.24}),
                 texture (random, {150, 215, 235}));
}

} // namespace pcl_msf::synthetic
