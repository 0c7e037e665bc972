// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cmath>

/* What is judged before clouds are aligned: camera, frame, size, depth limits. */
namespace {

using namespace pcl_msf;
using ::testing::HasSubstr;

using Cloud = RigidPair::Cloud;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZRGB>;

TEST (CloudCheck, AFewWildPointsAreNotTheCamera)
{
  const auto cloud = RigidPair::reference();
  PinholeCamera exact;
  ASSERT_TRUE (estimateCamera (pointImage (*cloud), exact));
  for (std::size_t i = 0; i < cloud->size(); i += 12) // edges, after a median filter
    (*cloud)[i].z *= i % 24 == 0 ? 0.01f : 1.7f;
  PinholeCamera camera;
  ASSERT_GT (projectionError (pointImage (*cloud), exact), 10.0);
  ASSERT_TRUE (estimateCamera (pointImage (*cloud), camera));
  EXPECT_NEAR (camera.fx, exact.fx, 0.01);
  EXPECT_NEAR (camera.fy, exact.fy, 0.01);
  EXPECT_NEAR (camera.cx, exact.cx, 0.01);
  EXPECT_NEAR (camera.cy, exact.cy, 0.01);
  EXPECT_TRUE (fitsCamera (pointImage (*cloud), RigidPair::camera()));
}

/** A frame that users keep clouds in, and what the message must say about it. */
struct OtherFrame {
  const char* name;
  Eigen::Matrix3f rotation; ///< user_from_optical
  Eigen::Vector3f offset;
  const char* words;
};

std::vector<OtherFrame>
otherFrames ()
{
  const Eigen::Vector3f here = Eigen::Vector3f::Zero();
  const auto turn = [] (float angle, const Eigen::Vector3f& axis) {
    return Eigen::AngleAxisf (angle, axis).toRotationMatrix();
  };
  const auto flip = [] (float x, float y, float z) {
    return Eigen::Matrix3f (Eigen::Vector3f (x, y, z).asDiagonal());
  };
  Eigen::Matrix3f body;
  body << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Eigen::Matrix3f down = turn (0.7f, Eigen::Vector3f::UnitX());
  return {{"mirror", flip (-1, 1, 1), here, "x is mirrored"},
          {"y up", flip (1, -1, 1), here, "y is mirrored"},
          {"viewer", flip (1, -1, -1), here, "y and z are flipped"},
          {"upside down", flip (-1, -1, 1), here, "x and y are flipped"},
          {"z back", flip (1, 1, -1), here, "z is mirrored"},
          {"body", body, here, "x is forward, y is left, z is up"},
          {"robot", body, {0.1f, 0, 1.2f}, "z is up; the camera is at (0.1, 0, 1.2)"},
          {"pitch", down, here, "rotated by 40.1 degrees about (1, 0, 0)"},
          {"mast", down, {0, 0, 1.5f}, "; the camera is at ("},
          {"map",
           flip (1, 1, 1),
           {1, 0, 0},
           "moved, to a map's frame perhaps: the "
           "camera is at (1, "},
          {"odometry",
           turn (0.2f, Eigen::Vector3f::UnitY()),
           {0.5f, 0, 0},
           "rotated by 11.5 degrees about (0, 1, 0)"}};
}

TEST (CloudCheck, CloudsOfAnotherFrameSayWhichOne)
{
  for (const OtherFrame& frame : otherFrames()) {
    SCOPED_TRACE (frame.name);
    const auto cloud = RigidPair::reference();
    (*cloud)[7].x = NAN;
    for (auto& p : *cloud)
      p.getVector3fMap() = frame.rotation * p.getVector3fMap() + frame.offset;
    for (std::size_t i = 0; i < cloud->size(); i += 50)
      (*cloud)[i].z += 0.3f; // an edge, filtered
    const cv::Mat points = coordinateImage (*cloud);
    std::string why;
    EXPECT_FALSE (fitsCamera (points, RigidPair::camera(), &why));
    EXPECT_THAT (why, HasSubstr (frame.words));
    EXPECT_THAT (why, HasSubstr ("x right, y down, z forward"));
    PinholeCamera camera;
    EXPECT_FALSE (estimateCamera (points, camera, &why));
    EXPECT_THAT (why, HasSubstr (frame.words));
  }
}

TEST (CloudCheck, AnotherCameraIsNamed)
{
  const cv::Mat points = coordinateImage (*RigidPair::reference());
  const PinholeCamera own = RigidPair::camera();
  const auto why = [&] (PinholeCamera camera) {
    std::string text;
    EXPECT_FALSE (fitsCamera (points, camera, &text));
    return text;
  };
  EXPECT_TRUE (fitsCamera (points, {own.fx, own.fy, own.cx + 0.5, own.cy - 0.5}));
  EXPECT_THAT (why ({2 * own.fx, 2 * own.fy, 159.5, 119.5}),
               HasSubstr ("own camera is fx 150, fy 152, cx 79.5, cy 60, 0.5 "
                          "times the focal length"));
  EXPECT_THAT (why ({own.fx, 2 * own.fy, own.cx, own.cy}),
               HasSubstr ("another camera's?"));
  EXPECT_THAT (why ({own.fx, own.fy, own.cx + 9.0, own.cy}),
               HasSubstr ("another principal point"));
  EXPECT_THAT (why ({-own.fx, own.fy, own.cx, own.cy}),
               HasSubstr ("focal lengths must be positive"));
}

TEST (CloudCheck, CloudsThatNoPinholeCameraSeesSaySo)
{
  pcl::PointCloud<pcl::PointXYZ> lidar (256, 64);
  for (int v = 0; v < 64; ++v)
    for (int u = 0; u < 256; ++u) {
      const double azimuth = M_PI * (u - 127.5) / 256, elevation = 0.01 * (v - 31.5);
      lidar (u, v).getVector3fMap() =
          (2.0 + 0.5 * std::sin (0.05 * u) + 0.01 * v) *
          Eigen::Vector3f (std::sin (azimuth) * std::cos (elevation),
                           std::sin (elevation),
                           std::cos (azimuth) * std::cos (elevation));
    }
  PinholeCamera camera;
  std::string why;
  EXPECT_FALSE (estimateCamera (coordinateImage (lidar), camera, &why));
  EXPECT_THAT (why, HasSubstr ("spinning lidar"));
  EXPECT_FALSE (fitsCamera (coordinateImage (lidar), {160, 100, 127.5, 31.5}, &why));
  EXPECT_THAT (why, HasSubstr ("spinning lidar"));
}

/** A plane leaves open how it was moved: there is a cause, and a remedy. */
TEST (CloudCheck, OnePlaneThatWasMovedSaysWhatIsNotDetermined)
{
  const auto turn = [] (float angle, const Eigen::Vector3f& axis) {
    return Eigen::AngleAxisf (angle, axis.normalized()).toRotationMatrix();
  };
  const PinholeCamera own = RigidPair::camera();
  const Eigen::Vector3f normals[] = {{0, 0, 1}, {0.3f, 0.5f, 1}};
  for (const Eigen::Vector3f& normal : normals)
    for (const auto& [rotation, offset] :
         {std::pair (turn (0.5f, {0, 0, 1}), Eigen::Vector3f (0, 0, 0)),
          std::pair (turn (0.5f, normal), Eigen::Vector3f (0.1f, 0, 0)),
          std::pair (turn (0.5f, {1, 2, 3}), Eigen::Vector3f (0.5f, 0.2f, 0.1f))}) {
      cv::Mat points (RigidPair::kHeight, RigidPair::kWidth, CV_32FC3);
      for (int v = 0; v < points.rows; ++v)
        for (int u = 0; u < points.cols; ++u) {
          const Eigen::Vector3f ray (static_cast<float> ((u - own.cx) / own.fx),
                                     static_cast<float> ((v - own.cy) / own.fy),
                                     1.0f);
          const Eigen::Vector3f p = rotation * (2.0f / normal.dot (ray) * ray) + offset;
          points.at<cv::Vec3f> (v, u) = {p.x(), p.y(), p.z()};
        }
      std::string why;
      PinholeCamera camera;
      EXPECT_FALSE (fitsCamera (points, own, &why));
      EXPECT_THAT (why, HasSubstr ("all points lie in one plane"));
      EXPECT_THAT (why, HasSubstr ("transform the cloud back"));
      EXPECT_FALSE (estimateCamera (points, camera, &why));
      EXPECT_THAT (why, HasSubstr ("all points lie in one plane"));
    }
}

TEST (CloudCheck, ANumberThatMarksWhatWasNotMeasuredIsNamed)
{
  const auto cloud = RigidPair::reference();
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (i % 5 != 0)
      (*cloud)[i].getVector3fMap().setConstant (1000.0f);
  PinholeCamera camera;
  std::string why;
  EXPECT_FALSE (estimateCamera (coordinateImage (*cloud), camera, &why));
  EXPECT_THAT (why, HasSubstr ("80 % of the points are (1000, 1000, 1000): write NaN"));
  EXPECT_FALSE (fitsCamera (coordinateImage (*cloud), RigidPair::camera(), &why));
  EXPECT_THAT (why, HasSubstr ("are (1000, 1000, 1000)"));
}

TEST (CloudCheck, ACornerTooFarFromThePrincipalPointSaysSo)
{
  const cv::Mat points = coordinateImage (*RigidPair::reference());
  PinholeCamera camera;
  std::string why;
  EXPECT_FALSE (estimateCamera (points (cv::Rect (0, 0, 20, 20)), camera, &why));
  EXPECT_THAT (why, HasSubstr ("no camera for 20x20 images: fx 150"));
}

TEST (CloudCheck, PointsThatAreTooFewSaySo)
{
  const auto full = RigidPair::reference();
  const auto whyOf = [&] (auto keep) {
    auto cloud = *full;
    for (int v = 0; v < RigidPair::kHeight; ++v)
      for (int u = 0; u < RigidPair::kWidth; ++u)
        if (!keep (u, v))
          cloud (u, v).z = NAN;
    PinholeCamera camera;
    std::string why;
    EXPECT_FALSE (estimateCamera (coordinateImage (cloud), camera, &why));
    return why;
  };
  EXPECT_THAT (whyOf ([] (int u, int) { return u == 30; }),
               HasSubstr ("lie in one column"));
  EXPECT_THAT (whyOf ([] (int, int v) { return v == 30; }),
               HasSubstr ("lie in one row"));
  EXPECT_THAT (whyOf ([] (int, int) { return false; }),
               HasSubstr ("no point has a depth"));
}

TEST (CloudCheck, TellsWhatTheDepthLimitsDrop)
{
  const auto printed = [] (float scale, double max_depth) {
    Registration registration;
    const auto grown = [scale] (Cloud::Ptr cloud) {
      for (auto& p : *cloud)
        p.getVector3fMap() *= scale;
      return cloud;
    };
    registration.setInputSource (grown (RigidPair::reference()));
    registration.setInputTarget (grown (RigidPair::current()));
    FrameParameters frame;
    frame.max_depth = max_depth;
    registration.setFrameParameters (frame);
    Cloud output;
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    registration.align (output);
    return testing::internal::GetCapturedStdout() +
           testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ (printed (1.0f, 1000.0), "");
  EXPECT_EQ (printed (1.0f, 2.4), ""); // a user's choice
  EXPECT_THAT (printed (450.0f, 1000.0), HasSubstr ("source: "));
  EXPECT_THAT (printed (450.0f, 1000.0), HasSubstr ("millimetres?"));
}

TEST (CloudCheck, TheLeastSizesAreRegistered)
{
  const Cloud::Ptr reference = RigidPair::reference();
  const Cloud::Ptr current = RigidPair::current();
  const auto crop = [] (const Cloud& cloud, cv::Size size) {
    auto part = pcl::make_shared<Cloud> (size.width, size.height);
    for (int v = 0; v < size.height; ++v)
      for (int u = 0; u < size.width; ++u)
        (*part) (u, v) =
            cloud (u + (160 - size.width) / 2, v + (120 - size.height) / 2);
    return part;
  };
  for (const cv::Size size : {cv::Size (12, 12), {12, 120}, {160, 13}, {47, 15}}) {
    Registration registration;
    registration.setInputSource (crop (*reference, size));
    registration.setInputTarget (crop (*current, size));
    Cloud output;
    registration.align (output);
    EXPECT_FALSE (registration.getSceneFlow().displacement.empty())
        << size << registration.getReport().message;
  }
}

} // namespace
