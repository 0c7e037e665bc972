// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// What recorded depth sensors do, and white noise does not.
#include <gtest/gtest.h>

#include "core/base/order_statistics.h"
#include "support/easy_sequences.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::test;

constexpr int lags[] = {1, 2, 4, 8, 16, 24};

SequenceOptions
roomOptions (Sensor sensor)
{
  SequenceOptions options;
  options.scene = SceneKind::StaticRoom;
  options.supersampling = 1;
  options.motion_pixels = 0.1;
  options.sensor = sensor;
  options.seed = 3;
  return options;
}

/** The room as a sensor sees it, rendered once. */
const SyntheticSequence&
room (Sensor sensor)
{
  static std::map<Sensor, SyntheticSequence> rooms;
  SyntheticSequence& sequence = rooms[sensor];
  if (sequence.frames.empty())
    sequence = synthesize (roomOptions (sensor));
  return sequence;
}

/** Error of inverse depth, frame 1's less frame 0's, clipped at three sigma: what an
 * alignment leaves. Bends that stay are not in it. NaN = unknown. */
cv::Mat
residualOf (Sensor sensor)
{
  cv::Mat residual (480, 640, CV_64FC1);
  std::vector<double> sizes;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const auto error = [&] (int k) {
        return 1.0 / room (sensor).frames[k].depth.at<float> (v, u) -
               1.0 / room (Sensor::Ideal).frames[k].depth.at<float> (v, u);
      };
      residual.at<double> (v, u) = error (1) - error (0);
      if (std::isfinite (residual.at<double> (v, u)))
        sizes.push_back (std::abs (residual.at<double> (v, u)));
    }
  const double limit = 3.0 * kMadToSigma * median (sizes);
  for (int v = 0; v < 480; ++v)
    for (double* r = residual.ptr<double> (v); r < residual.ptr<double> (v) + 640; ++r)
      if (std::isfinite (*r))
        *r = std::clamp (*r, -limit, limit);
  return residual;
}

double
correlationAlongRows (const cv::Mat& residual, int lag)
{
  double xy = 0.0, xx = 0.0, yy = 0.0;
  for (int v = 0; v < residual.rows; ++v)
    for (int u = 0; u + lag < residual.cols; ++u) {
      const double x = residual.at<double> (v, u), y = residual.at<double> (v, u + lag);
      if (!std::isfinite (x + y))
        continue;
      xy += x * y;
      xx += x * x;
      yy += y * y;
    }
  return xy / std::sqrt (xx * yy);
}

// Kinect: mean of four recordings, RealSense: one. A window of L pixels has exp (-1 /
// L): the others' as their descriptions say.
TEST (DepthSensors, NoiseCorrelationIsThatOfRecordings)
{
  const std::map<Sensor, std::vector<double>> recorded{
      {Sensor::White, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}},
      {Sensor::Kinect, {0.71, 0.50, 0.25, 0.04, 0.01, 0.01}},
      {Sensor::RealSense, {0.85, 0.78, 0.62, 0.38, 0.10, 0.04}},
      {Sensor::TimeOfFlight, {0.37, 0.14, 0.02, 0.0, 0.0, 0.0}},
      {Sensor::Stereo, {0.78, 0.61, 0.37, 0.14, 0.02, 0.0}}};
  for (const auto& [sensor, at] : recorded) {
    const cv::Mat residual = residualOf (sensor);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR (correlationAlongRows (residual, lags[i]), at[i], 0.15)
          << toString (sensor) << ", " << lags[i] << " pixels";
  }
}

/** Median of a depth's error over its square, 1 / m, between two depths. */
double
medianError (Sensor sensor, double from, double to)
{
  std::vector<double> errors;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const double z = room (Sensor::Ideal).frames[0].depth.at<float> (v, u);
      const double error = room (sensor).frames[0].depth.at<float> (v, u) - z;
      if (z >= from && z < to && std::isfinite (error))
        errors.push_back (std::abs (error) / (z * z));
    }
  return errors.size() < 1000 ? 0.0 : median (errors);
}

TEST (DepthSensors, ErrGrowsWithTheSquareOfDistance)
{
  for (const Sensor sensor : {Sensor::Kinect, Sensor::RealSense, Sensor::Stereo}) {
    const double near = medianError (sensor, 1.0, 3.0);
    const double far = medianError (sensor, 4.0, 6.0);
    EXPECT_GT (near, 5e-4) << toString (sensor);
    EXPECT_GT (far, 0.6 * near) << toString (sensor);
    EXPECT_LT (far, 1.6 * near) << toString (sensor);
  }
}

/** Share of the pixels beside a nearer surface, so many pixels away from it in its row,
 * that show something clearly nearer than what is there. */
double
fattened (Sensor sensor, int distance)
{
  const cv::Mat& exact = room (Sensor::Ideal).frames[0].depth;
  int wide = 0, all = 0;
  for (int v = 0; v < 480; ++v)
    for (int u = 20; u < 620; ++u)
      for (const int side : {-1, 1}) {
        const float near = exact.at<float> (v, u), far = exact.at<float> (v, u + side);
        const int x = u + side * distance;
        const float seen = room (sensor).frames[0].depth.at<float> (v, x);
        if (!(far > 1.3F * near) || std::abs (exact.at<float> (v, x) - far) > 0.1F ||
            std::isnan (seen))
          continue;
        ++all;
        wide += seen < 0.9F * far;
      }
  EXPECT_GT (all, 100) << toString (sensor);
  return static_cast<double> (wide) / all;
}

TEST (DepthSensors, WindowsFattenWhatIsNearer)
{
  for (const Sensor sensor : {Sensor::Kinect, Sensor::RealSense, Sensor::Stereo}) {
    EXPECT_GT (fattened (sensor, 1), 0.8) << toString (sensor);
    EXPECT_LT (fattened (sensor, 12), 0.2) << toString (sensor);
  }
  EXPECT_GT (fattened (Sensor::RealSense, 3), 2.0 * fattened (Sensor::Kinect, 4));
}

TEST (DepthSensors, TimeOfFlightMeasuresCornersTooFar)
{
  const cv::Mat& exact = room (Sensor::Ideal).frames[0].depth;
  const cv::Mat& seen = room (Sensor::TimeOfFlight).frames[0].depth;
  std::vector<double> errors;
  for (int v = 240; v < 480; ++v)
    for (int u = 200; u < 340; ++u) {
      const double z = exact.at<float> (v, u), error = seen.at<float> (v, u) - z;
      const double below = exact.at<float> (std::min (v + 3, 479), u);
      if (std::isfinite (error) && z > 3.5 &&
          below < z - 0.02) // the floor, at the wall
        errors.push_back (error);
    }
  ASSERT_GT (errors.size(), 500U);
  const double middle = median (errors);
  EXPECT_GT (middle, 0.01);
  EXPECT_LT (middle, 0.2);
}

TEST (DepthSensors, RealSenseHasHolesWhereNothingIsToBeMatched)
{
  SequenceOptions options = roomOptions (Sensor::RealSense);
  options.frames = 1;
  const auto holes = [] (const SyntheticSequence& sequence) {
    return 1.0 - cv::countNonZero (sequence.frames[0].depth > 0.0F) / (640.0 * 480.0);
  };
  options.scene = SceneKind::TexturePoor;
  EXPECT_GT (holes (synthesize (options)), 0.25);
  EXPECT_LT (holes (room (Sensor::RealSense)), 0.1);
}

TEST (DepthSensors, AreTheSameForAnyNumberOfThreadsAndLeaveTheTruth)
{
  const SyntheticSequence& exact = easySequence (SceneKind::MultiBody);
  for (const Sensor sensor : allSensors()) {
    SequenceOptions options = smallOptions (SceneKind::MultiBody);
    options.sensor = sensor;
    options.effects.rolling_shutter = 0.4;
    options.effects.depth_delay = 0.5;
    options.effects.depth_shift_x = 1.5;
    options.effects.distortion.k1 = 0.05;
    options.threads = 1;
    const SyntheticSequence one = synthesize (options);
    options.threads = 3;
    const SyntheticSequence three = synthesize (options);
    for (int k = 0; k < 2; ++k) {
      EXPECT_TRUE (sameBits (one.frames[k].color, three.frames[k].color));
      EXPECT_TRUE (sameBits (one.frames[k].depth, three.frames[k].depth))
          << toString (sensor);
    }
    EXPECT_TRUE (sameBits (one.truth[1].flow, exact.truth[1].flow));
    EXPECT_TRUE (sameBits (one.labels, exact.labels));
    EXPECT_EQ (sensorFromName (toString (sensor)), sensor);
  }
  EXPECT_THROW (sensorFromName ("lidar"), InvalidInput);
}

} // namespace
