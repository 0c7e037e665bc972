// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/cameras.h"

#include <pcl/pcl_config.h>
#ifdef PCL_MSF_HAS_OPENNI2
#include <pcl/io/openni2_grabber.h>
#endif
#ifdef PCL_MSF_HAS_REALSENSE2
#include <pcl/io/real_sense_2_grabber.h>
#endif
#include <pcl/point_types.h>

#include <exception>

namespace pcl_msf::tool {

namespace {

#if !defined(PCL_MSF_HAS_OPENNI2) || !defined(PCL_MSF_HAS_REALSENSE2)
[[noreturn]] void
refuse (const std::string& name, const std::string& grabber, const std::string& remedy)
{
  throw UsageError (name + ": this program is built without pcl::" + grabber + "; " +
                    remedy + ", then build pcl_msf again");
}
#endif

std::unique_ptr<pcl::Grabber>
openOpenNI2 (const PlayerSettings& settings)
{
#ifdef PCL_MSF_HAS_OPENNI2
  return std::make_unique<pcl::io::OpenNI2Grabber> (settings.source);
#else
  refuse (cameraName (settings),
          "io::OpenNI2Grabber",
          "install OpenNI2 (Debian: libopenni2-dev) and a PCL that has it");
#endif
}

std::unique_ptr<pcl::Grabber>
openRealSense2 (const PlayerSettings& settings)
{
#ifdef PCL_MSF_HAS_REALSENSE2
  constexpr bool repeat = false; // of a recording by its name
  return std::make_unique<pcl::RealSense2Grabber> (settings.source, repeat);
#else
  refuse (cameraName (settings),
          "RealSense2Grabber",
          "install librealsense2 and a PCL that is built with WITH_RSSDK2=ON");
#endif
}

/** What PCL's exceptions say behind the place where they come from. */
std::string
causeOf (const std::exception& error)
{
  const std::string text = error.what();
  const std::size_t place = text.rfind (" : ");
  return place == std::string::npos ? text : text.substr (place + 3);
}

} // namespace

std::string
cameraName (const PlayerSettings& settings)
{
  const bool openni = settings.grabber == GrabberKind::OpenNI2;
  return std::string ("--grabber ") + (openni ? "openni2" : "realsense2") +
         (settings.source.empty() ? ", any camera"
                                  : ", camera '" + settings.source + "'");
}

std::unique_ptr<pcl::Grabber>
openCamera (const PlayerSettings& settings)
{
  try {
    return settings.grabber == GrabberKind::OpenNI2 ? openOpenNI2 (settings)
                                                    : openRealSense2 (settings);
  }
  catch (const UsageError&) {
    throw;
  }
  catch (const std::exception& e) {
    throw UsageError (cameraName (settings) + ": " + causeOf (e) +
                      " Connect one, see that you may read it (udev rules), or give "
                      "another one's number, as #1, or serial number as SOURCE");
  }
}

} // namespace pcl_msf::tool
