// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/lens_distortion.h>
#include <pcl_msf/pinhole_camera.h>

#include <optional>
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
 * Errors in depth are correlated over the window that a sensor matches, lengths are in
 * pixels of the image. Recorded sensors show the same correlation along rows after
 * alignment (at 1, 2, 4, 8 pixels: first Kinect .71 .50 .25 .03, RealSense .85 .78 .62
 * .38). Errors of disparity grow in metres with z^2.
 *
 * All have colour with noise of 2.5 / 255, a vignette and an exposure that differs from
 * frame to frame, see CameraEffects. */
enum class Sensor {
  Ideal, ///< exact depth, clean colour

  /** Structured light: 580 px focal length, 0.075 m baseline; disparity errs by 0.09 px
   * over a window of about 3 px, has slow bends of 0.4 % and steps of 1/8 px; depth
   * borders are fattened by 1 to 3 px and have flying pixels; no measurement in the
   * projector's shadow, on surfaces seen at more than about 80 deg, nearer than 0.4 m.
   */
  Kinect,

  /** What Kinect was until version 0.2: noise without any correlation (disparity 0.06
   * px), steps of 1/8 px, shadows, ragged borders. For comparison. */
  White,

  /** Active stereo: 600 px, 0.05 m; disparity errs by 0.08 px over a window of about 8
   * px, borders are fattened by 2 to 5 px; steps of 1/32 px; holes where neither
   * texture nor light marks the surface; noisy far away. */
  RealSense,

  /** Time of flight: noise that grows with distance, dark and slanted surfaces; a
   * wiggle with distance; light that came by way of a corner (too far by centimetres);
   * mixed pixels at depth borders; nothing beyond 12 m. */
  TimeOfFlight,

  /** Two cameras: 580 px, 0.2 m; disparity errs by 0.15 px over a window of about 4 px,
   * four times that without texture; borders fattened by 2 to 5 px; steps of 1/16 px;
   * no measurement where the second camera sees nothing. */
  Stereo
};

/** \brief "static_room", "multi_body", ... */
PCL_MSF_EXPORT const char*
toString (SceneKind scene);

/** \brief All scenes, in the order of the enumeration. */
PCL_MSF_EXPORT const std::vector<SceneKind>&
allScenes ();

/** \brief The scene of a name as toString writes it. \throws InvalidInput listing all
 * names for another one */
PCL_MSF_EXPORT SceneKind
sceneFromName (const std::string& name);

/** \brief "none", "kinect", "white", "realsense", "tof", "stereo" */
PCL_MSF_EXPORT const char*
toString (Sensor sensor);

/** \brief All sensors; Ideal first. */
PCL_MSF_EXPORT const std::vector<Sensor>&
allSensors ();

/** \brief The sensor of a name as toString writes it. \throws InvalidInput listing all
 * names for another one */
PCL_MSF_EXPORT Sensor
sensorFromName (const std::string& name);

/** \brief What a camera does to its images, with any sensor. Truth stays that of the
 * ideal camera: a pinhole that sees all at once, at the frame's time. Times are shares
 * of the frame interval (1/30 s). */
struct CameraEffects {
  /** \brief Where depth is shown, away from where colour shows it: what calibration
   * left, pixels, [-20, 20]. */
  double depth_shift_x{0.0};
  double depth_shift_y{0.0}; ///< likewise

  /** \brief How much later than colour depth was measured, shares of the frame
   * interval, [-1, 1]: 10 to 30 ms are 0.3 to 0.9. */
  double depth_delay{0.0};

  /** \brief From the first row to the last one, shares of the frame interval, [0, 1];
   * the middle one is read at the frame's time. */
  double rolling_shutter{0.0};

  /** \brief The lens, of colour and depth; shown by images, unknown to the camera. */
  LensDistortion distortion;

  /** \brief Exposure differs from frame to frame by up to this share, [0, 0.5]; none =
   * 0.03, without a sensor 0. */
  std::optional<double> exposure_change;

  /** \brief Corners are darker by this share, [0, 1]; none = 0.12, without a sensor 0.
   */
  std::optional<double> vignette;
};

/** \brief What to generate. The same options give the same sequence, bit for bit, for
 * any number of threads. */
struct PCL_MSF_EXPORT SequenceOptions {
  SceneKind scene{SceneKind::MultiBody};
  MotionSize motion{MotionSize::Easy};
  Sensor sensor{Sensor::Ideal};
  int width{640};   ///< pixels, [16, 4096]
  int height{480};  ///< pixels, [16, 4096]
  int frames{2};    ///< [1, 1000]
  unsigned seed{1}; ///< places, colours, textures, motions and noise

  /** \brief Of the noise alone, so that one scene can be measured again and again; none
   * (default) = `seed`. */
  std::optional<unsigned> noise_seed;

  int supersampling{3}; ///< colour rays per pixel and axis, [1, 8]
  CameraEffects effects;
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

  /** \brief `camera`, or the default one for the size. */
  PinholeCamera
  usedCamera () const;

  /** \brief Compute the truth from each frame to its successor, too. */
  bool successive_truth{false};

  /** \param[out] why when not null and the answer is no: which value and its range */
  bool
  isValid (std::string* why = nullptr) const;
};

} // namespace pcl_msf::synthetic
