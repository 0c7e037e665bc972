// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/motion/rigid_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr double kRotationPrior =
    4.0; // pixels per radian, per sample: holds noise down

/** A sample seen under a motion: residuals in pixels, lever about the centroid. */
struct Reprojection {
  Eigen::Vector3d lever;
  Eigen::Vector3d q;
  double ru, rv;
  double rw; ///< inverse depth error in its standard deviations
};

class FlowFit {
public:
  FlowFit (const FlowSample* samples, int count, const RigidFitOptions& options)
  : samples_ (samples), count_ (count), options_ (options)
  {
    for (int i = 0; i < count; ++i)
      center_ += Eigen::Vector3d (samples[i].x, samples[i].y, samples[i].z);
    center_ /= std::max (1, count);
  }

  RigidPose
  run (const RigidPose& start)
  {
    rotation_ = start.rotation();
    translation_ = start.translation();
    for (int i = 0; i < options_.iterations; ++i)
      if (!step())
        break;
    return RigidPose::fromMatrix (rotation_, translation_);
  }

  double
  error (const FlowSample& s) const
  {
    const Reprojection r = reproject (s);
    const double depth = s.inverse_depth > 0.0f ? r.rw : 0.0;
    return std::sqrt (r.ru * r.ru + r.rv * r.rv + 0.05 * depth * depth);
  }

  void
  place (const RigidPose& pose)
  {
    rotation_ = pose.rotation();
    translation_ = pose.translation();
  }

private:
  Reprojection
  reproject (const FlowSample& s) const
  {
    Reprojection r;
    const Eigen::Vector3d rp = rotation_ * Eigen::Vector3d (s.x, s.y, s.z);
    r.q = rp + translation_;
    r.lever = rp - rotation_ * center_;
    const double iz = 1.0 / std::max (r.q.z(), 1e-3);
    r.ru = options_.camera.fx * r.q.x() * iz + options_.camera.cx - s.u;
    r.rv = options_.camera.fy * r.q.y() * iz + options_.camera.cy - s.v;
    r.rw = (iz - s.inverse_depth) /
           (options_.inverse_depth_sigma + options_.relative_sigma * s.inverse_depth);
    return r;
  }

  double
  medianError ()
  {
    errors_.resize (count_);
    for (int i = 0; i < count_; ++i) {
      const Reprojection r = reproject (samples_[i]);
      errors_[i] = static_cast<float> (r.ru * r.ru + r.rv * r.rv);
    }
    std::nth_element (errors_.begin(), errors_.begin() + count_ / 2, errors_.end());
    return std::sqrt (errors_[count_ / 2]);
  }

  void
  accumulate (const Reprojection& r, bool depth, double scale, Matrix6& a, Vector6& b);

  bool
  step ();

  const FlowSample* samples_;
  int count_;
  const RigidFitOptions& options_;
  Eigen::Vector3d center_{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d rotation_{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d translation_{Eigen::Vector3d::Zero()};
  std::vector<float> errors_;
};

void
FlowFit::accumulate (
    const Reprojection& r, bool depth, double scale, Matrix6& a, Vector6& b)
{
  const double iz = 1.0 / std::max (r.q.z(), 1e-3);
  const auto add = [&] (const Eigen::Vector3d& j, double residual, double weight) {
    Vector6 full;
    full.head<3>() = r.lever.cross (j);
    full.tail<3>() = j;
    a += weight * full * full.transpose();
    b += weight * residual * full;
  };
  const double s2 = scale * scale;
  const double e2 = r.ru * r.ru + r.rv * r.rv;
  const double w = s2 / ((s2 + e2) * (s2 + e2)) * s2;
  const double fx = options_.camera.fx * iz;
  const double fy = options_.camera.fy * iz;
  add ({fx, 0.0, -fx * r.q.x() * iz}, r.ru, w);
  add ({0.0, fy, -fy * r.q.y() * iz}, r.rv, w);
  if (!depth)
    return;
  constexpr double kDepthScale = 3.0;  // standard deviations
  constexpr double kDepthWeight = 0.2; // pixels^2 per standard deviation^2
  const double d2 = kDepthScale * kDepthScale;
  const double wd =
      w * kDepthWeight * d2 * d2 / ((d2 + r.rw * r.rw) * (d2 + r.rw * r.rw));
  const double sigma = options_.inverse_depth_sigma + options_.relative_sigma * iz;
  add ({0.0, 0.0, -iz * iz / sigma}, r.rw, wd);
}

bool
FlowFit::step()
{
  const double scale = std::max (options_.smallest_scale, 2.0 * medianError());
  Matrix6 a = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  for (int i = 0; i < count_; ++i)
    accumulate (reproject (samples_[i]), samples_[i].inverse_depth > 0.0f, scale, a, b);
  const Eigen::Vector3d rotation_vector = vectorFromRotation (rotation_);
  const double prior = kRotationPrior * kRotationPrior * count_;
  a.topLeftCorner<3, 3>().diagonal().array() += prior;
  b.head<3>() += prior * rotation_vector;
  a.diagonal().array() += 1e-9 * a.trace() + 1e-12;
  const Vector6 x = -Eigen::LDLT<Matrix6> (a).solve (b);
  if (!x.allFinite())
    return false;
  // Left perturbation about the warped centre: q -> dR (q - o) + o + dt.
  const Eigen::Matrix3d dr = rotationFromVector (x.head<3>());
  const Eigen::Vector3d o = rotation_ * center_ + translation_;
  translation_ = dr * (translation_ - o) + o + x.tail<3>();
  rotation_ = dr * rotation_;
  return true;
}

} // namespace

RigidPose
fitRigidMotion (const FlowSample* samples,
                int count,
                const RigidPose& start,
                const RigidFitOptions& options)
{
  if (count < 1)
    return start;
  return FlowFit (samples, count, options).run (start);
}

double
meanTruncatedError (const FlowSample* samples,
                    int count,
                    const RigidPose& pose,
                    const RigidFitOptions& options,
                    double limit)
{
  FlowFit fit (samples, count, options);
  fit.place (pose);
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
    sum += std::min (limit, fit.error (samples[i]));
  return sum / std::max (1, count);
}

} // namespace pcl_msf
