// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/scene_builders.h>
#include <synthetic/scene_props.h>
#include <synthetic/skeleton.h>

#include <string>

namespace pcl_msf::synthetic {
namespace {

/** A joint at the end of its parent's link, which runs along z. */
Joint
jointAfter (int parent,
            double length,
            const Eigen::Vector3d& bend_degrees,
            const Eigen::Vector3d& turn,
            double start)
{
  Joint joint;
  joint.parent = parent;
  joint.parent_from_joint = placed (0, 0, length, bend_degrees);
  joint.turn = turn;
  joint.start = start;
  return joint;
}

void
addLink (SceneModel& scene, Random& random, int body, double length, double radius)
{
  scene.addPart (
      body, placed (0, 0, 0), makeCapsule (length, radius), anyTexture (random));
  scene.addPart (body,
                 placed (0, 0, 0.5 * length),
                 makeBox ({1.05 * radius, 1.05 * radius, 0.25 * length}),
                 anyTexture (random));
}

/** One finger of three links; they curl around their x axis. */
void
addFinger (SceneModel& scene,
           Random& random,
           Skeleton& skeleton,
           std::vector<double>& lengths,
           const Isometry& palm_from_root,
           const std::string& name,
           double length)
{
  const double curl = random.uniform (0.012, 0.035), start = random.uniform (-0.6, 0.6);
  int parent = 1; // the palm
  for (int i = 0; i < 3; ++i) {
    Joint joint;
    joint.parent = parent;
    joint.parent_from_joint =
        i == 0 ? palm_from_root : placed (0, 0, lengths[parent], {8, 0, 0});
    joint.turn = Eigen::Vector3d (curl, i == 0 ? 0.004 * random.sign() : 0.0, 0.0);
    joint.start = start;
    parent = skeleton.add (joint);
    lengths.push_back (length * (1.0 - 0.22 * i));
    scene.addBody (name + "_" + std::to_string (i + 1), atRest());
    scene.addPart (parent + 1,
                   placed (0, 0, 0),
                   makeCapsule (lengths[parent], 0.026 - 0.003 * i),
                   texture (random,
                            {120.0f + 12.0f * i, 150.0f + 10.0f * i, 205.0f},
                            Pattern::Patches,
                            {95, 120, 180},
                            0.03f));
  }
}

} // namespace

SceneModel
buildArticulated (Random& random)
{
  SceneModel scene;
  addRoom (scene, random);
  addFurniture (scene, random);
  auto skeleton = std::make_shared<Skeleton>();
  const double side = random.sign(), length = 0.4;
  // Up, over, down in front of itself, and up again.
  const Eigen::Vector3d bends[] = {{90, 0, 0},
                                   {-12, 50 * side, 0},
                                   {35, 80 * side, 0},
                                   {10, 85 * side, 0},
                                   {-25, 65 * side, 0},
                                   {20, -60 * side, 0}};
  Joint root = jointAfter (-1, 0, bends[0], {0.004, 0.012 * side, 0}, 0.0);
  root.parent_from_joint = placed (-0.42 * side, 0.72, 1.9, bends[0]);
  skeleton->add (root);
  for (int i = 1; i < 6; ++i) {
    Eigen::Vector3d turn = random.uniform (0.018, 0.035) * random.direction();
    turn.y() += 0.012 * random.sign();
    skeleton->add (
        jointAfter (i - 1, length, bends[i], turn, random.uniform (-.5, .5)));
  }
  for (int i = 0; i < 6; ++i) {
    const int body =
        scene.addBody ("link_" + std::to_string (i + 1), linkMotion (skeleton, i));
    addLink (scene, random, body, length, 0.105 - 0.008 * i);
  }
  scene.addPart (0,
                 placed (-0.42 * side, 1.02, 1.9, {90, 0, 0}),
                 makeCylinder (0.18, 0.22),
                 anyTexture (random));
  scene.world_from_camera = handHeld (random, 0.5);
  return scene;
}

SceneModel
buildHand (Random& random)
{
  SceneModel scene;
  addRoom (scene, random, 3.2);
  addFurniture (scene, random);
  auto skeleton = std::make_shared<Skeleton>();
  const double side = random.sign();
  const Texture skin =
      texture (random, {125, 155, 205}, Pattern::Patches, {100, 130, 185}, 0.04f);
  Joint elbow = jointAfter (-1, 0, {0, 0, 0}, {0.003, 0.006, 0.006}, 0.2);
  elbow.parent_from_joint = placed (0.12 * side, 0.5, 1.15, {97, 0, 8 * side});
  skeleton->add (elbow);
  skeleton->add (jointAfter (0, 0.3, {0, 0, 0}, {0.012, 0.008, 0.004}, 0.1));
  scene.addBody ("forearm", atRest());
  scene.addBody ("palm", atRest());
  scene.addPart (1, placed (0, 0, -0.1), makeCapsule (0.38, 0.06), skin);
  scene.addPart (2, placed (0, 0, 0.11), makeEllipsoid ({0.115, 0.045, 0.14}), skin);
  std::vector<double> lengths{0.3, 0.2};
  const double reach[] = {0.085, 0.095, 0.088, 0.07};
  for (int i = 0; i < 4; ++i)
    addFinger (
        scene,
        random,
        *skeleton,
        lengths,
        placed (-0.08 + 0.055 * i, 0, 0.2 + (i % 3 ? 0.02 : 0.0), {5, 5. * i - 8, 0}),
        "finger_" + std::to_string (i + 1),
        reach[i]);
  addFinger (scene,
             random,
             *skeleton,
             lengths,
             placed (-0.09 * side, -0.02, 0.07, {15, -50 * side, 0}),
             "thumb",
             0.08);
  for (int link = 0; link + 1 < static_cast<int> (scene.bodies.size()); ++link)
    scene.bodies[link + 1].world_from_body = linkMotion (skeleton, link);
  scene.world_from_camera = handHeld (random, 0.4);
  return scene;
}

} // namespace pcl_msf::synthetic
