// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_term.h"
#include <ceres/autodiff_cost_function.h>
#include <ceres/jet.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/rotation.h>

#include <algorithm>
#include <cmath>
#include <memory>

// Eq. 5 once more, written down plainly and independently of the library: one
// automatically differentiated residual per pixel and term. Slow; the measure of what
// the library's compressed blocks must reproduce.

namespace pcl_msf {
namespace test {

inline double
valueOf (double x)
{
  return x;
}

template <int N>
double
valueOf (const ceres::Jet<double, N>& x)
{
  return x.a;
}

/** \brief Bilinear interpolation in the cell that the point lies in; beyond the image
 * its border, without a slope. */
template <typename T>
T
bilinearIntensity (const kernel::Image& image, T u, T v)
{
  const auto confine = [] (T& x, double last) {
    if (valueOf (x) < 0.0)
      x = T (0.0);
    if (valueOf (x) > last)
      x = T (last);
  };
  confine (u, image.width - 1.0);
  confine (v, image.height - 1.0);
  const int u0 =
      std::min (static_cast<int> (std::floor (valueOf (u))), image.width - 2);
  const int v0 =
      std::min (static_cast<int> (std::floor (valueOf (v))), image.height - 2);
  const auto at = [&] (int du, int dv) {
    return T (
        static_cast<double> (image.texels[2 * ((v0 + dv) * image.width + u0 + du)]));
  };
  const T a = u - T (u0);
  const T b = v - T (v0);
  return (T (1.0) - a) * (T (1.0) - b) * at (0, 0) + a * (T (1.0) - b) * at (1, 0) +
         (T (1.0) - a) * b * at (0, 1) + a * b * at (1, 1);
}

/** \brief q = R (pose) p + t by Rodrigues' formula (Eq. 4). */
template <typename T>
void
move (const T* pose, const Eigen::Vector3d& p, T* q)
{
  const T point[3] = {T (p.x()), T (p.y()), T (p.z())};
  ceres::AngleAxisRotatePoint (pose, point, q);
  for (int i = 0; i < 3; ++i)
    q[i] += pose[3 + i];
}

/** \brief Inside of Eq. 6, over its standard deviation. */
struct BrightnessResidual {
  kernel::Image image;
  Eigen::Vector3d point;
  double intensity;
  double scale;

  template <typename T>
  bool
  operator() (const T* pose, T* residual) const
  {
    T q[3];
    move (pose, point, q);
    const T u =
        static_cast<double> (image.fx) * q[0] / q[2] + static_cast<double> (image.cx);
    const T v =
        static_cast<double> (image.fy) * q[1] / q[2] + static_cast<double> (image.cy);
    residual[0] = scale * (bilinearIntensity (image, u, v) - intensity);
    return true;
  }
};

/** \brief Inside of Eq. 8 at a kept correspondence, over its standard deviation. */
struct PlaneResidual {
  Eigen::Vector3d point;
  Eigen::Vector3d normal; ///< carried to the current frame
  double offset;          ///< normal . p_corr
  double scale;

  template <typename T>
  bool
  operator() (const T* pose, T* residual) const
  {
    T q[3];
    move (pose, point, q);
    residual[0] =
        scale * (normal.x() * q[0] + normal.y() * q[1] + normal.z() * q[2] - offset);
    return true;
  }
};

/** \brief What hidden points cost, whatever the pose. */
struct ConstantResidual {
  double cost;

  template <typename T>
  bool
  operator() (const T*, T* residual) const
  {
    residual[0] = T (std::sqrt (2.0 * cost));
    return true;
  }
};

/** \brief Eq. 10 and 11 for one link. */
struct LinkResidual {
  SegmentLink link;
  PoseDifference form;
  double unit;
  double root_gamma, root_eta; ///< of the weights divided by the number of links

  template <typename T>
  bool
  operator() (const T* first, const T* second, const T* w, T* residual) const
  {
    T d[6];
    for (int i = 0; i < 6; ++i)
      d[i] = first[i] - second[i];
    if (form == PoseDifference::Metric) {
      T a[3];
      T b[3];
      move (first, link.midpoint, a);
      move (second, link.midpoint, b);
      for (int i = 0; i < 3; ++i) {
        d[3 + i] = unit * link.lever * d[i];
        d[i] = unit * (a[i] - b[i]);
      }
    }
    for (int i = 0; i < 6; ++i)
      residual[i] = root_gamma * w[0] * w[0] * d[i];
    residual[6] = root_eta * (1.0 - w[0] * w[0]);
    return true;
  }
};

/** \brief Eq. 7 as Ceres has it (rho (r^2) / 2), times a weight. */
inline ceres::LossFunction*
weightedHuber (double epsilon, double weight)
{
  ceres::LossFunction* huber = epsilon < 0.0 ? nullptr : new ceres::HuberLoss (epsilon);
  return new ceres::ScaledLoss (huber, weight, ceres::TAKE_OWNERSHIP);
}

/** \brief Adds the data terms of one segment at the correspondences that the data term
 * keeps. */
inline void
addSegment (const DataTerm& data, int segment, double* pose, ceres::Problem& problem)
{
  const SegmentPixels& p = data.pixels();
  kernel::Rules rules = data.rules();
  rules.brightness_weight *= static_cast<float> (p.pixels_per_point[segment]);
  rules.icp_weight *= static_cast<float> (p.pixels_per_point[segment]);
  const auto constant = [&] (double cost) {
    problem.AddResidualBlock (new ceres::AutoDiffCostFunction<ConstantResidual, 1, 6> (
                                  new ConstantResidual{cost}),
                              nullptr,
                              pose);
  };
  for (int i = p.begin[segment]; i < p.begin[segment + 1]; ++i) {
    const Eigen::Vector3d point (p.x[i], p.y[i], p.z[i]);
    const int active = data.active()[i];
    double hidden = rules.conflict_cost;
    if (active & kernel::kUnknown)
      hidden = rules.unknown_cost;
    if (active & kernel::kOccluded)
      hidden = rules.occluded_cost;
    if (active & kernel::kOutside)
      hidden = rules.outside_cost;
    if (p.brightness_scale[i] > 0.0f && (active & kernel::kBrightness))
      problem.AddResidualBlock (
          new ceres::AutoDiffCostFunction<BrightnessResidual, 1, 6> (
              new BrightnessResidual{
                  data.image(), point, p.intensity[i], p.brightness_scale[i]}),
          weightedHuber (rules.huber, rules.brightness_weight),
          pose);
    else if (p.brightness_scale[i] > 0.0f)
      constant (hidden * rules.brightness_weight);
    if (p.icp_scale[i] > 0.0f && (active & kernel::kIcp)) {
      const double reference[3] = {p.nx[i], p.ny[i], p.nz[i]};
      Eigen::Vector3d normal;
      ceres::AngleAxisRotatePoint (
          data.frozenPose (segment).parameters.data(), reference, normal.data());
      problem.AddResidualBlock (
          new ceres::AutoDiffCostFunction<PlaneResidual, 1, 6> (
              new PlaneResidual{point, normal, data.planeOffsets()[i], p.icp_scale[i]}),
          weightedHuber (rules.huber, rules.icp_weight),
          pose);
    }
    else if (p.icp_scale[i] > 0.0f)
      constant (hidden * rules.icp_weight);
  }
}

/** \brief The whole of Eq. 5 over the poses and weights of a state of one pair, which
 * must outlive it. */
inline std::unique_ptr<ceres::Problem>
autodiffEnergy (const DataTerm& data,
                const std::vector<SegmentLink>& links,
                const EnergyParameters& energy,
                double focal_length,
                WindowState& state)
{
  auto problem = std::make_unique<ceres::Problem>();
  for (std::size_t k = 0; k < state.body_of.size(); ++k)
    addSegment (data,
                static_cast<int> (k),
                state.poses[0][state.body_of[k]].parameters.data(),
                *problem);
  const auto count = static_cast<double> (links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const int j = state.body_of[links[i].first];
    const int h = state.body_of[links[i].second];
    if (j == h)
      continue;
    problem->AddResidualBlock (
        new ceres::AutoDiffCostFunction<LinkResidual, 7, 6, 6, 1> (
            new LinkResidual{links[i],
                             energy.pose_difference,
                             focal_length / links[i].midpoint.z(),
                             std::sqrt (energy.regularizer_weight / count),
                             std::sqrt (energy.prior_weight / count)}),
        nullptr,
        state.poses[0][j].parameters.data(),
        state.poses[0][h].parameters.data(),
        &state.weights[i]);
  }
  return problem;
}

} // namespace test
} // namespace pcl_msf
