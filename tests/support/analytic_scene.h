// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Geometry>

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/rigid_pose.h>

#include <cmath>
#include <limits>
#include <vector>

namespace pcl_msf {
namespace test {

/** \brief Smooth texture in [0, 1] of a surface coordinate in metres; the shortest
 * wavelength is 0.13 m. */
inline double
texture (double a, double b, double phase)
{
  return 0.5 + 0.16 * std::sin (18.0 * a + 7.0 * b + phase) +
         0.14 * std::sin (-11.0 * a + 27.0 * b + 2.0 * phase) +
         0.12 * std::sin (41.0 * a + 24.0 * b + 3.0 * phase) +
         0.06 * std::cos (-37.0 * b + 15.0 * a - phase);
}

/** \brief A textured parallelogram on a rigid body. */
struct Quad {
  Eigen::Vector3d corner, right, down; ///< metres, reference frame
  int body;
  double phase; ///< of the texture
};

/** \brief Colour, depth and the body of each pixel; NaN and -1 where nothing is seen.
 */
struct View {
  cv::Mat color; ///< CV_32FC1
  cv::Mat depth; ///< CV_32FC1, metres
  cv::Mat body;  ///< CV_32SC1
};

/** \brief The view with a fifth of its contrast. */
inline View
faded (const View& view)
{
  View result = view;
  result.color = 0.4 + 0.2 * (view.color - 0.4);
  return result;
}

/** \brief The view under another light: a lamp shines from the side, and the camera
 * answers to it otherwise. */
inline View
underOtherLight (const View& view)
{
  View result = view;
  result.color = view.color.clone();
  const double width = view.color.cols, height = view.color.rows;
  for (int y = 0; y < view.color.rows; ++y)
    for (int x = 0; x < view.color.cols; ++x) {
      const double i = view.color.at<float> (y, x);
      const double light =
          0.85 + 0.15 * std::sin (1.0 + 3.0 * x / width) * std::cos (2.5 * y / height);
      result.color.at<float> (y, x) = static_cast<float> (light * std::pow (i, 1.2));
    }
  return result;
}

/** \brief What really happened to each reference pixel. */
struct Truth {
  cv::Mat flow;    ///< CV_32FC2, pixels; NaN without depth
  cv::Mat visible; ///< CV_8UC1: seen in both frames
};

/** \brief Parallelograms on rigid bodies, seen before and after the bodies' motions. */
struct AnalyticScene {
  PinholeCamera camera{150.0, 150.0, 79.5, 59.5};
  int width{160};
  int height{120};
  std::vector<Quad> quads;
  std::vector<RigidPose> motions; ///< per body, current_from_reference

  /** \brief Where a ray meets the nearest quad. */
  struct Hit {
    double depth{std::numeric_limits<double>::infinity()};
    double intensity{0.0};
    int body{-1};
  };

  Hit
  cast (double u, double v, bool moved) const
  {
    const Eigen::Vector3d ray = camera.backProject (u, v, 1.0);
    Hit hit;
    for (const Quad& q : quads) {
      const RigidPose pose = moved ? motions[q.body] : RigidPose{};
      const Eigen::Matrix3d r = pose.rotation();
      const Eigen::Vector3d corner = pose * q.corner;
      const Eigen::Vector3d right = r * q.right;
      const Eigen::Vector3d down = r * q.down;
      const Eigen::Vector3d normal = right.cross (down);
      const double z = normal.dot (corner) / normal.dot (ray);
      const Eigen::Vector3d on = z * ray - corner;
      const double a = on.cross (down).dot (normal) / normal.squaredNorm();
      const double b = right.cross (on).dot (normal) / normal.squaredNorm();
      if (!(z > 0.0 && z < hit.depth && a >= 0.0 && a <= 1.0 && b >= 0.0 && b <= 1.0))
        continue;
      hit = {z, texture (a * right.norm(), b * down.norm(), q.phase), q.body};
    }
    return hit;
  }

  View
  render (bool moved) const
  {
    View view{cv::Mat (height, width, CV_32FC1, cv::Scalar (0)),
              cv::Mat (height,
                       width,
                       CV_32FC1,
                       cv::Scalar (std::numeric_limits<float>::quiet_NaN())),
              cv::Mat (height, width, CV_32SC1, cv::Scalar (-1))};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Hit hit = cast (x, y, moved);
        if (hit.body < 0)
          continue;
        view.color.at<float> (y, x) = static_cast<float> (hit.intensity);
        view.depth.at<float> (y, x) = static_cast<float> (hit.depth);
        view.body.at<int> (y, x) = hit.body;
      }
    return view;
  }

  Truth
  truth (const View& reference) const
  {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    Truth result{cv::Mat (height, width, CV_32FC2, cv::Scalar (kNan, kNan)),
                 cv::Mat (height, width, CV_8UC1, cv::Scalar (0))};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int body = reference.body.at<int> (y, x);
        if (body < 0)
          continue;
        const Eigen::Vector3d q =
            motions[body] * camera.backProject (x, y, reference.depth.at<float> (y, x));
        const Eigen::Vector2d uv = camera.project (q);
        result.flow.at<cv::Vec2f> (y, x) = {static_cast<float> (uv.x() - x),
                                            static_cast<float> (uv.y() - y)};
        const bool inside = uv.x() >= 0.0 && uv.x() <= width - 1.0 && uv.y() >= 0.0 &&
                            uv.y() <= height - 1.0;
        if (inside && q.z() < cast (uv.x(), uv.y(), true).depth + 1e-3)
          result.visible.at<unsigned char> (y, x) = 255;
      }
    return result;
  }

  RgbdFrame
  frame (const View& view, const FrameParameters& parameters = {}) const
  {
    return RgbdFrame::fromImages (view.color, view.depth, camera, parameters);
  }
};

/** \brief A pose that turns by `rotation` about `center` and then shifts. */
inline RigidPose
turnAbout (const Eigen::Vector3d& center,
           const Eigen::Vector3d& rotation,
           const Eigen::Vector3d& shift)
{
  const Eigen::Matrix3d r = rotationFromVector (rotation);
  return RigidPose::fromMatrix (r, center - r * center + shift);
}

/** \brief A back wall, a receding floor and a side wall (body 0: the camera's motion)
 * with a box in front of them (body 1). The box covers a strip of the wall that it did
 * not cover before. */
inline AnalyticScene
roomWithBox ()
{
  using Eigen::Vector3d;
  AnalyticScene s;
  s.quads.push_back ({{-4, -3, 3.2}, {8, 0, 0}, {0, 6, 0}, 0, 0.3});
  s.quads.push_back ({{-4, 0.9, 0.5}, {8, 0, 0}, {0, 0, 4}, 0, 1.9});
  s.quads.push_back ({{-1.5, -3, 0.5}, {0, 0, 4}, {0, 6, 0}, 0, 4.1});
  const Vector3d corner (-0.35, -0.25, 1.8);
  const Eigen::Matrix3d r = rotationFromVector ({0.0, 0.35, 0.0});
  const Vector3d right = r * Vector3d (0.7, 0, 0);
  const Vector3d down = r * Vector3d (0, 0.6, 0);
  const Vector3d deep = r * Vector3d (0, 0, 0.5);
  s.quads.push_back ({corner, right, down, 1, 0.0});
  s.quads.push_back ({corner, deep, down, 1, 2.5});
  s.quads.push_back ({corner + right, deep, down, 1, 1.2});
  s.quads.push_back ({corner, right, deep, 1, 5.0});
  s.quads.push_back ({corner + down, right, deep, 1, 3.3});
  const Vector3d center = corner + 0.5 * (right + down + deep);
  s.motions.push_back (
      turnAbout ({0, 0, 2.5}, {0.004, -0.006, 0.005}, {-0.02, 0.01, 0.01}));
  s.motions.push_back (turnAbout (center, {0.0, 0.04, 0.05}, {0.06, -0.02, -0.03}));
  return s;
}

} // namespace test
} // namespace pcl_msf
