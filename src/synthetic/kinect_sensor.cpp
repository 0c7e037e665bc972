// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Khoshelham and Elberink, "Accuracy and Resolution of Kinect Depth Data for Indoor
// Mapping Applications", Sensors 2012: steps of 1/8 pixel, a random error of 4 cm at 5
// m. Nguyen, Izadi and Lovell, "Modeling Kinect Sensor Noise for Improved 3D
// Reconstruction and Tracking", 3DIMPVT 2012: growth with z^2, limits of slant.
// Teichman, Miller and Thrun, "Unsupervised Intrinsic Calibration of Depth Sensors via
// SLAM", RSS 2013: slow bends.
#include <synthetic/matching_sensor.h>

namespace pcl_msf::synthetic {

void
applyKinect (const SensorInput& input, cv::Mat& depth)
{
  MatchingSensor sensor{};
  sensor.focal = 580.0;
  sensor.baseline = 0.075;
  sensor.second = Side::Left;
  sensor.error = 0.09;
  sensor.window = 3.5;
  sensor.bend = 0.004;
  sensor.steps = 8.0;
  sensor.fattening = 3;
  sensor.flying = 0.25;
  sensor.lost = 0.3;
  sensor.nearest = 0.4;
  sensor.least = 1.0;
  applyMatching (sensor, input, {}, {}, depth);
}

} // namespace pcl_msf::synthetic
