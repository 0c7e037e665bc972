// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/surface_texture.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/base/parallel_for.h"
#include "core/surface/point_tree.h"

#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

constexpr int kUnknowns = 3;         // of a fitted plane: value and two slopes
constexpr int kFewest = 6;           // points around a point that a plane is fitted to
constexpr float kFacing = 0.5f;      // cosine between normals of one side of a surface
constexpr double kFlat = 1e-12;      // of the squared brightness: rounding
constexpr double kDegenerate = 1e-6; // determinant of places that lie along a line

struct Fit {
  bool known{false};
  double value{0.0};
  Eigen::Vector3d gradient{Eigen::Vector3d::Zero()};
  double noise{0.0};  ///< variance of the gradient, summed over its directions
  double square{0.0}; ///< mean squared brightness
};

/** What least squares tell of places in a point's plane and the brightness there. */
Fit
fitPlane (const std::vector<Eigen::Vector3d>& rows,
          const std::vector<double>& values,
          const Eigen::Vector3d& u,
          const Eigen::Vector3d& v,
          double radius)
{
  Fit fit;
  const auto n = static_cast<double> (rows.size());
  if (rows.size() < kFewest)
    return fit;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    normal += rows[i] * rows[i].transpose();
    right += values[i] * rows[i];
    fit.square += values[i] * values[i] / n;
  }
  if (!(normal.determinant() > kDegenerate * n * n * n))
    return fit;
  const Eigen::Matrix3d inverse = normal.inverse();
  const Eigen::Vector3d plane = inverse * right;
  double rest = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    rest += std::pow (values[i] - plane.dot (rows[i]), 2);
  fit.known = true;
  fit.value = plane[0];
  fit.gradient = (plane[1] * u + plane[2] * v) / radius;
  fit.noise =
      rest / (n - kUnknowns) * (inverse (1, 1) + inverse (2, 2)) / (radius * radius);
  return fit;
}

Fit
fitAround (const Surface& surface,
           const std::vector<float>& brightness,
           const std::vector<FoundPoint>& neighbors,
           int i,
           double radius)
{
  const Eigen::Vector3d normal = surface.normals[i].cast<double>();
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross (u);
  std::vector<Eigen::Vector3d> rows; // lengths in radii
  std::vector<double> values;
  for (const FoundPoint& f : neighbors) {
    if (f.squared_distance > radius * radius || !std::isfinite (brightness[f.index]) ||
        surface.normals[f.index].dot (surface.normals[i]) < kFacing)
      continue;
    const Eigen::Vector3d d =
        (surface.points[f.index] - surface.points[i]).cast<double>() / radius;
    rows.emplace_back (1.0, u.dot (d), v.dot (d));
    values.push_back (brightness[f.index]);
  }
  return fitPlane (rows, values, u, v, radius);
}

} // namespace

SurfaceTexture
fitTexture (const Surface& surface,
            const std::vector<float>& brightness,
            double radius,
            int most,
            int threads)
{
  SurfaceTexture texture;
  if (brightness.empty())
    return texture;
  const PointTree tree (surface.points);
  std::vector<Fit> fits (surface.size());
  parallelFor (threads, surface.size(), 64, [&] (int i) {
    std::vector<FoundPoint> neighbors;
    tree.nearest (surface.points[i].data(), most, neighbors);
    fits[i] = fitAround (surface, brightness, neighbors, i, radius);
  });
  double squares = 0.0;
  double noise = 0.0;
  double flat = 0.0;
  int known = 0;
  for (const Fit& fit : fits) {
    texture.value.push_back (fit.known ? static_cast<float> (fit.value)
                                       : std::numeric_limits<float>::quiet_NaN());
    texture.gradient.emplace_back (fit.gradient.cast<float>());
    squares += fit.gradient.squaredNorm();
    noise += fit.noise;
    flat += kFlat * fit.square / (radius * radius);
    known += fit.known ? 1 : 0;
  }
  if (squares > noise + flat) {
    texture.trust = 1.0 - noise / squares;
    texture.slope = std::sqrt ((squares - noise) / known);
  }
  return texture;
}

std::vector<float>
meanBrightness (const Surface& surface,
                const std::vector<float>& brightness,
                const std::vector<int>& chosen,
                int threads)
{
  if (brightness.empty())
    return {};
  std::vector<Eigen::Vector3f> places;
  for (const int i : chosen)
    places.push_back (surface.points[i]);
  const PointTree tree (places);
  std::vector<int> nearest (surface.size());
  parallelFor (threads, surface.size(), 256, [&] (int i) {
    nearest[i] = tree.nearest (surface.points[i]).index;
  });
  std::vector<double> sums (chosen.size(), 0.0);
  std::vector<int> counts (chosen.size(), 0);
  for (int i = 0; i < surface.size(); ++i)
    if (std::isfinite (brightness[i])) {
      sums[nearest[i]] += brightness[i];
      ++counts[nearest[i]];
    }
  std::vector<float> means;
  for (std::size_t k = 0; k < sums.size(); ++k)
    means.push_back (static_cast<float> (sums[k] / counts[k])); // 0 / 0 is NaN
  return means;
}

} // namespace pcl_msf
