// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/two_bodies.h"

namespace pcl_msf {
namespace test {

constexpr double kWallDepth = 2.4; // metres: 20 pixels are 0.32 m
constexpr int kWallTile = 10;      // at rest, far from the plate
constexpr int kBeside = 18;        // left of the plate
constexpr int kPlateTile = 19;     // the plate, all of it
constexpr int kCovered = 20; // the wall right of the plate, which comes to hide it
constexpr int kFree = 28;    // below kCovered, seen in both frames

/** \brief A resting wall of eight by six tiles (body 0) and in front of it a plate as
 * large as a tile (body 1), which moves one tile to the right and a little nearer, so
 * that it also hides a pixel around. */
inline AnalyticScene
coveredWall ()
{
  AnalyticScene s;
  s.quads.push_back ({{-4, -3, kWallDepth}, {8, 0, 0}, {0, 6, 0}, 0, 0.3});
  s.quads.push_back ({{-0.16, -0.16, 1.2}, {0.16, 0, 0}, {0, 0.16, 0}, 1, 1.1});
  s.motions.push_back (RigidPose{});
  s.motions.push_back (turnAbout ({0, 0, 0}, {0, 0, 0}, {0.153, 0.007, -0.1}));
  return s;
}

/** \brief A shift of points on the wall by whole tiles. */
inline RigidPose
tilesAway (double right, double down)
{
  return turnAbout ({0, 0, 0}, {0, 0, 0}, {0.32 * right, 0.32 * down, 0});
}

/** \brief Makes segments look like everything. */
inline void
wipeTexture (SegmentPixels& pixels, int first, int last)
{
  for (int i = pixels.begin[first]; i < pixels.begin[last + 1]; ++i)
    pixels.brightness_scale[i] = 0.0f;
}

/** \brief Gives a segment a body of its own. */
inline void
setApart (MotionState& state, int segment, const RigidPose& pose)
{
  state.body_of[segment] = static_cast<int> (state.poses.size());
  state.poses.push_back (pose);
}

} // namespace test
} // namespace pcl_msf
