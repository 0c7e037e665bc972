// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/sensor_model.h>

namespace pcl_msf::synthetic {

void
applyDepthSensor (Sensor sensor, const SensorInput& input, cv::Mat& depth)
{
  switch (sensor) {
  case Sensor::Ideal:
    return;
  case Sensor::Kinect:
    return applyKinect (input, depth);
  case Sensor::White:
    return applyWhite (input, depth);
  case Sensor::RealSense:
    return applyRealSense (input, depth);
  case Sensor::TimeOfFlight:
    return applyTimeOfFlight (input, depth);
  case Sensor::Stereo:
    return applyStereo (input, depth);
  }
}

} // namespace pcl_msf::synthetic
