// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_options.h>

#include <cmath>
#include <string>

namespace pcl_msf::synthetic {
namespace {

/** The one of a list that has the name. */
template <typename Kind>
Kind
named (const std::string& name, const std::vector<Kind>& all, const char* what)
{
  std::string names;
  for (const Kind kind : all) {
    if (name == toString (kind))
      return kind;
    names += std::string (names.empty() ? "" : ", ") + toString (kind);
  }
  throw InvalidInput (std::string ("no ") + what + " is called '" + name +
                      "'; there are " + names);
}

} // namespace

const char*
toString (SceneKind scene)
{
  switch (scene) {
  case SceneKind::StaticRoom:
    return "static_room";
  case SceneKind::MultiBody:
    return "multi_body";
  case SceneKind::Articulated:
    return "articulated";
  case SceneKind::Hand:
    return "hand";
  case SceneKind::Bending:
    return "bending";
  case SceneKind::Breathing:
    return "breathing";
  case SceneKind::Street:
    return "street";
  case SceneKind::TexturePoor:
    return "texture_poor";
  case SceneKind::ThinStructures:
    return "thin_structures";
  }
  return "unknown";
}

const char*
toString (Sensor sensor)
{
  switch (sensor) {
  case Sensor::Ideal:
    return "none";
  case Sensor::Kinect:
    return "kinect";
  case Sensor::White:
    return "white";
  case Sensor::RealSense:
    return "realsense";
  case Sensor::TimeOfFlight:
    return "tof";
  case Sensor::Stereo:
    return "stereo";
  }
  return "unknown";
}

const std::vector<Sensor>&
allSensors ()
{
  static const std::vector<Sensor> sensors{Sensor::Ideal,
                                           Sensor::White,
                                           Sensor::Kinect,
                                           Sensor::RealSense,
                                           Sensor::TimeOfFlight,
                                           Sensor::Stereo};
  return sensors;
}

const std::vector<SceneKind>&
allScenes ()
{
  static const std::vector<SceneKind> scenes{SceneKind::StaticRoom,
                                             SceneKind::MultiBody,
                                             SceneKind::Articulated,
                                             SceneKind::Hand,
                                             SceneKind::Bending,
                                             SceneKind::Breathing,
                                             SceneKind::Street,
                                             SceneKind::TexturePoor,
                                             SceneKind::ThinStructures};
  return scenes;
}

SceneKind
sceneFromName (const std::string& name)
{
  return named (name, allScenes(), "scene");
}

Sensor
sensorFromName (const std::string& name)
{
  return named (name, allSensors(), "sensor");
}

PinholeCamera
SequenceOptions::usedCamera() const
{
  if (camera.fx != 0.0)
    return camera;
  const double f = 0.82 * width;
  return {f, f, 0.5 * (width - 1), 0.5 * (height - 1)};
}

bool
SequenceOptions::isValid (std::string* why) const
{
  std::string problem;
  const auto check = [&] (const char* name, double value, double low, double high) {
    if (problem.empty() && !(value >= low && value <= high))
      problem = std::string (name) + " = " + generalText (value) +
                " must lie between " + generalText (low) + " and " + generalText (high);
  };
  check ("scene", static_cast<int> (scene), 0, allScenes().size() - 1.0);
  check ("width", width, 16, 4096);
  check ("height", height, 16, 4096);
  check ("frames", frames, 1, 1000);
  check ("supersampling", supersampling, 1, 8);
  check ("sensor", static_cast<int> (sensor), 0, allSensors().size() - 1.0);
  check ("motion_pixels", motion_pixels, 0, 200);
  check ("depth_shift_x", effects.depth_shift_x, -20, 20);
  check ("depth_shift_y", effects.depth_shift_y, -20, 20);
  check ("depth_delay", effects.depth_delay, -1, 1);
  check ("rolling_shutter", effects.rolling_shutter, 0, 1);
  check ("exposure_change", effects.exposure_change.value_or (0.0), 0, 0.5);
  check ("vignette", effects.vignette.value_or (0.0), 0, 1);
  if (problem.empty() && camera.fx != 0.0)
    camera.isValid (width, height, &problem);
  if (problem.empty())
    effects.distortion.isValid (usedCamera(), width, height, &problem);
  if (why)
    *why = problem;
  return problem.empty();
}

} // namespace pcl_msf::synthetic
