// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/pinhole_camera.h>

#include <string>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief What is generated. Numbers of bodies count those that have a label. */
enum class SceneKind {
  StaticRoom,    ///< a furnished room, moving camera; one body
  MultiBody,     ///< rigid bodies that move differently in the room; camera moves, too
  Articulated,   ///< a chain of six links with joints, in front of itself
  Hand,          ///< a tree of links: forearm, palm, five fingers of three links
  Bending,       ///< a sheet that bends and twists; not rigid
  Breathing,     ///< a torso whose surface swells in waves; not piecewise rigid
  Street,        ///< ground plane to 80 m, houses, cars; the sky has no depth
  TexturePoor,   ///< the room and bodies of few, faint marks
  ThinStructures ///< rods, frames, grids a few pixels wide, some of them moving
};

/** \brief How far the image moves from frame to frame. */
enum class MotionSize {
  Easy, ///< 4 pixels from frame to frame, at a width of 640
  Large ///< 22 pixels, at a width of 640
};

/** \brief What the sensor does to colour and depth. Ground truth stays exact.
 *
 * Kinect is structured light (580 px focal length, 0.075 m baseline): disparity with
 * Gaussian noise of 0.06 px, rounded to 1/8 px, so that errors in metres grow with z^2
 * (at 2 m steps of 12 mm); no measurement in the projector's shadow, in ragged borders
 * of depth edges, on surfaces seen at more than about 80 deg, nearer than 0.4 m and
 * beyond 43.5 m. Colour gets a vignette (corners 12 % darker), an exposure that differs
 * by up to 3 % from frame to frame, Gaussian noise of 2.5 / 255. */
enum class Sensor {
  Ideal, ///< exact depth, clean colour
  Kinect ///< structured light
};

/** \brief "static_room", "multi_body", ... */
const char*
toString (SceneKind scene);

/** \brief All scenes, in the order of the enumeration. */
const std::vector<SceneKind>&
allScenes ();

/** \brief The scene of a name as toString writes it. \throws InvalidInput listing all
 * names for another one */
SceneKind
sceneFromName (const std::string& name);

/** \brief What to generate. The same options give the same sequence, bit for bit, for
 * any number of threads. */
struct SequenceOptions {
  SceneKind scene{SceneKind::MultiBody};
  MotionSize motion{MotionSize::Easy};
  Sensor sensor{Sensor::Ideal};
  int width{640};          ///< pixels, [16, 4096]
  int height{480};         ///< pixels, [16, 4096]
  int frames{2};           ///< [1, 1000]
  unsigned seed{1};        ///< places, colours, textures, motions and noise
  int supersampling{3};    ///< colour rays per pixel and axis, [1, 8]
  bool motion_blur{false}; ///< shutter open for half of the frame interval
  unsigned threads{0};     ///< 0 = all; the result does not depend on it

  /** \brief Average image motion between frames 0 and 1 in pixels at a width of 640 (it
   * scales with the width), [0, 200]; 0 = what `motion` says. The average is that of
   * all points or of those on moving bodies, whichever is more. Reached within 10 %
   * where the scene's bounded motion allows it, which goes to about 25 pixels. */
  double motion_pixels{0.0};

  /** \brief Camera; fx = 0 (default) = focal length 0.82 width, principal point in the
   * centre. */
  PinholeCamera camera;

  /** \brief Compute the truth from each frame to its successor, too. */
  bool successive_truth{false};

  /** \param[out] why when not null and the answer is no: which value and its range */
  bool
  isValid (std::string* why = nullptr) const;
};

} // namespace pcl_msf::synthetic
