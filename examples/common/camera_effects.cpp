// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/camera_effects.h"

#include "common/recordings.h"

namespace pcl_msf::tool {

Words<synthetic::Sensor>
sensorWords ()
{
  Words<synthetic::Sensor> words;
  for (const synthetic::Sensor sensor : synthetic::allSensors())
    words.emplace_back (toString (sensor), sensor);
  return words;
}

void
addCameraEffects (CLI::App& app, synthetic::CameraEffects& e)
{
  beginGroup (app, "What the camera does besides; truth is that of an ideal one");
  addOption (app,
             "--depth-shift",
             "X,Y",
             "where depth lies, away from colour, pixels",
             [&e] (const std::string& text) {
               double xy[2];
               if (!parseList (text, ',', xy))
                 return false;
               e.depth_shift_x = xy[0];
               e.depth_shift_y = xy[1];
               return true;
             });
  addNumber (app,
             "--depth-delay",
             "T",
             "of depth after colour; shares of the frame interval of 1/30 s",
             e.depth_delay);
  addNumber (app,
             "--rolling-shutter",
             "T",
             "from the first row to the last, likewise",
             e.rolling_shutter);
  addDistortion (app,
                 "--lens",
                 "distortion that the images show",
                 [&e] (const LensDistortion& l) { e.distortion = l; });
  addNumber (app,
             "--exposure-change",
             "S",
             "share by which exposure differs [0.03; none: 0]",
             e.exposure_change);
  addNumber (app,
             "--vignette",
             "S",
             "share by which corners are darker [0.12; none: 0]",
             e.vignette);
}

std::string
distortionText (const LensDistortion& lens)
{
  std::string text;
  for (const double value : {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3})
    text += (text.empty() ? "" : ",") + generalText (value);
  return text;
}

std::string
effectsText (const synthetic::CameraEffects& e)
{
  std::string text;
  const auto tell = [&text] (const char* name, std::initializer_list<double> values) {
    bool any = false;
    for (const double value : values)
      any |= value != 0.0;
    if (!any)
      return;
    text += std::string (" ") + name + "=";
    for (const double value : values)
      text += (text.back() == '=' ? "" : ",") + generalText (value);
  };
  tell ("depth_shift", {e.depth_shift_x, e.depth_shift_y});
  tell ("depth_delay", {e.depth_delay});
  tell ("rolling_shutter", {e.rolling_shutter});
  if (!e.distortion.isNone())
    text += " lens=" + distortionText (e.distortion);
  if (e.exposure_change)
    text += " exposure_change=" + generalText (*e.exposure_change);
  if (e.vignette)
    text += " vignette=" + generalText (*e.vignette);
  return text;
}

} // namespace pcl_msf::tool
