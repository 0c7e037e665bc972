// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/motion/flow_evidence.h"

#include <Eigen/Geometry>

#include <utility>

namespace pcl_msf {

namespace {

constexpr double kNearest = 1e-3; // metres: nothing nearer has an image

using Projection = Eigen::Matrix<double, 2, 3>;

/** J' J and J' r of residuals by a left perturbation about the origin: rotation, then
 * translation. */
struct PoseSums {
  Matrix6 information{Matrix6::Zero()}; ///< upper triangle
  Vector6 gradient{Vector6::Zero()};

  /** \param turned the point less the pose's translation */
  void
  add (const Projection& by_point,
       const Eigen::Vector3d& turned,
       const Eigen::Vector2d& r,
       double scale)
  {
    for (int row = 0; row < 2; ++row) {
      const Eigen::Vector3d b = by_point.row (row);
      Vector6 j;
      j << turned.cross (b), b;
      const Vector6 scaled = scale * j;
      for (int c = 0; c < 6; ++c)
        for (int k = 0; k <= c; ++k)
          information (k, c) += scaled[k] * j[c];
      gradient += r[row] * scaled;
    }
  }

  /** Adds them by pose parameters. \param left Jacobian of the rotation vector */
  void
  addTo (const Eigen::Matrix3d& left, Matrix6& a, Vector6& b) const
  {
    Matrix6 basis = Matrix6::Identity();
    basis.topLeftCorner<3, 3>() = left;
    const Matrix6 whole = information.selfadjointView<Eigen::Upper>();
    a += basis.transpose() * whole * basis;
    b += basis.transpose() * gradient;
  }
};

} // namespace

FlowEvidence::FlowEvidence (std::vector<FlowMatch> matches,
                            std::vector<int> begin,
                            const PinholeCamera& camera,
                            double cap)
: matches_ (std::move (matches))
, begin_ (std::move (begin))
, camera_ (camera)
, cap_ (cap)
{}

double
FlowEvidence::cost (int segment,
                    const UnpackedPose& pose,
                    double weight,
                    Matrix6* information,
                    Vector6* gradient) const
{
  const int count = begin_[segment + 1] - begin_[segment];
  if (count == 0)
    return 0.0;
  PoseSums sums;
  const double cap2 = cap_ * cap_;
  double sum = 0.0;
  for (int i = begin_[segment]; i < begin_[segment + 1]; ++i) {
    const FlowSample& s = matches_[i].sample;
    const Eigen::Vector3d turned = pose.rotation * Eigen::Vector3d (s.x, s.y, s.z);
    const Eigen::Vector3d p = turned + pose.translation;
    if (!(p.z() > kNearest)) {
      sum += 0.5 * cap2;
      continue;
    }
    const float* w = matches_[i].whitening;
    Eigen::Matrix2d whitening;
    whitening << w[0], w[1], w[1], w[2];
    const double x = camera_.fx / p.z();
    const double y = camera_.fy / p.z();
    const Eigen::Vector2d r =
        whitening *
        Eigen::Vector2d (x * p.x() + camera_.cx - s.u, y * p.y() + camera_.cy - s.v);
    const double robust = cap2 / (cap2 + r.squaredNorm());
    sum += 0.5 * robust * r.squaredNorm();
    if (!information)
      continue;
    Projection by_point;
    by_point << x, 0.0, -x * p.x() / p.z(), 0.0, y, -y * p.y() / p.z();
    sums.add (whitening * by_point, turned, r, weight * robust * robust / count);
  }
  if (information)
    sums.addTo (leftJacobian (pose.rotation_vector), *information, *gradient);
  return sum / count;
}

} // namespace pcl_msf
