// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/motion/rigid_fit.h"

#include <Eigen/Cholesky>

#include "core/base/order_statistics.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr int kBlock = 64;        // samples worked on at a time
constexpr double kSettled = 0.01; // pixels: a step that moves the samples less is last

/** Samples seen under a motion, one array a quantity: each loop over them vectorizes.
 */
struct Block {
  float x[kBlock], y[kBlock], z[kBlock];    ///< about the centre
  float u[kBlock], v[kBlock], w[kBlock];    ///< where flow says they went
  float lx[kBlock], ly[kBlock], lz[kBlock]; ///< turned: levers about the centre
  float qx[kBlock], qy[kBlock], iz[kBlock]; ///< moved
  float ru[kBlock], rv[kBlock];             ///< residuals, pixels
  float rw[kBlock]; ///< inverse depth error in its standard deviations
};

/** Normal equations about the warped centre: upper triangle of A, and b. */
struct Equations {
  double a[6][6]{};
  double b[6]{};
  double weight{0.0};
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
    place (start);
    for (int i = 0; i < options_.tuning.iterations; ++i)
      if (!step())
        break;
    return RigidPose::fromMatrix (rotation_, translation_);
  }

  void
  place (const RigidPose& pose)
  {
    rotation_ = pose.rotation();
    translation_ = pose.translation();
  }

  /** Calls visit (index, error) for every sample: pixels, and a share for the depth. */
  template <typename Visit>
  void
  forEachError (const Visit& visit)
  {
    const float share = options_.tuning.depth_share;
    forEachBlock ([&] (int first, int n, const Block& k) {
      float errors[kBlock];
#pragma omp simd
      for (int i = 0; i < n; ++i) {
        const float depth = k.w[i] > 0.0f ? k.rw[i] : 0.0f;
        errors[i] =
            std::sqrt (k.ru[i] * k.ru[i] + k.rv[i] * k.rv[i] + share * depth * depth);
      }
      for (int i = 0; i < n; ++i)
        visit (first + i, errors[i]);
    });
  }

private:
  /** Calls visit (first, n, block) for all samples as the present motion shows them. */
  template <typename Visit>
  void
  forEachBlock (const Visit& visit)
  {
    Block k;
    for (int first = 0; first < count_; first += kBlock) {
      const int n = std::min (kBlock, count_ - first);
      load (first, n, k);
      reproject (n, k);
      visit (first, n, k);
    }
  }
  void
  load (int first, int n, Block& k) const;
  void
  reproject (int n, Block& k) const;
  double
  medianError ();
  void
  accumulate (int n, const Block& k, double scale, Equations& e) const;
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
FlowFit::load (int first, int n, Block& k) const
{
  const FlowSample* s = samples_ + first;
  const auto cx = static_cast<float> (center_.x());
  const auto cy = static_cast<float> (center_.y());
  const auto cz = static_cast<float> (center_.z());
  for (int i = 0; i < n; ++i) {
    k.x[i] = s[i].x - cx;
    k.y[i] = s[i].y - cy;
    k.z[i] = s[i].z - cz;
    k.u[i] = s[i].u;
    k.v[i] = s[i].v;
    k.w[i] = s[i].inverse_depth;
  }
}

void
FlowFit::reproject (int n, Block& k) const
{
  const Eigen::Matrix3f r = rotation_.cast<float>();
  // As rounded when the samples were taken about it.
  const Eigen::Vector3d center = center_.cast<float>().cast<double>();
  const Eigen::Vector3f o = (rotation_ * center + translation_).cast<float>();
  const float r0 = r (0, 0), r1 = r (0, 1), r2 = r (0, 2);
  const float r3 = r (1, 0), r4 = r (1, 1), r5 = r (1, 2);
  const float r6 = r (2, 0), r7 = r (2, 1), r8 = r (2, 2);
  const float ox = o.x(), oy = o.y(), oz = o.z();
  const auto fx = static_cast<float> (options_.camera.fx);
  const auto fy = static_cast<float> (options_.camera.fy);
  const auto cx = static_cast<float> (options_.camera.cx);
  const auto cy = static_cast<float> (options_.camera.cy);
  const auto sigma = static_cast<float> (options_.inverse_depth_sigma);
  const auto share = static_cast<float> (options_.relative_sigma);
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    k.lx[i] = r0 * k.x[i] + r1 * k.y[i] + r2 * k.z[i];
    k.ly[i] = r3 * k.x[i] + r4 * k.y[i] + r5 * k.z[i];
    k.lz[i] = r6 * k.x[i] + r7 * k.y[i] + r8 * k.z[i];
    k.qx[i] = k.lx[i] + ox;
    k.qy[i] = k.ly[i] + oy;
    const float qz = k.lz[i] + oz;
    k.iz[i] = 1.0f / (qz > 1e-3f ? qz : 1e-3f);
    k.ru[i] = fx * k.qx[i] * k.iz[i] + cx - k.u[i];
    k.rv[i] = fy * k.qy[i] * k.iz[i] + cy - k.v[i];
    k.rw[i] = (k.iz[i] - k.w[i]) / (sigma + share * k.w[i]);
  }
}

double
FlowFit::medianError()
{
  errors_.resize (count_);
  forEachBlock ([&] (int first, int n, const Block& k) {
    for (int i = 0; i < n; ++i)
      errors_[first + i] = k.ru[i] * k.ru[i] + k.rv[i] * k.rv[i];
  });
  return std::sqrt (median (errors_));
}

/** With rows j of a sample's residuals by its translation, all rows are [l x j; j]: A
 * is made of M = sum w j j' and b of g = sum w r j, crossed with the lever l. */
void
FlowFit::accumulate (int n, const Block& k, double scale, Equations& e) const
{
  const auto s2 = static_cast<float> (scale * scale);
  const float d2 = options_.tuning.depth_scale * options_.tuning.depth_scale;
  const float depth_weight = options_.tuning.depth_weight;
  const auto camera_fx = static_cast<float> (options_.camera.fx);
  const auto camera_fy = static_cast<float> (options_.camera.fy);
  const auto sigma_w = static_cast<float> (options_.inverse_depth_sigma);
  const auto share = static_cast<float> (options_.relative_sigma);
  float total = 0;
  float a00 = 0, a01 = 0, a02 = 0, a11 = 0, a12 = 0, a22 = 0; // l x M x l
  float c00 = 0, c01 = 0, c02 = 0, c10 = 0, c11 = 0, c12 = 0, c20 = 0, c21 = 0,
        c22 = 0;                                        // l x M
  float m00 = 0, m02 = 0, m11 = 0, m12 = 0, m22 = 0;    // M
  float t0 = 0, t1 = 0, t2 = 0, g0 = 0, g1 = 0, g2 = 0; // l x g, g
#pragma omp simd reduction(+ : total, a00, a01, a02, a11, a12, a22, c00, c01, c02,      \
                               c10, c11, c12, c20, c21, c22, m00, m02, m11, m12, m22,   \
                               t0, t1, t2, g0, g1, g2)
  for (int i = 0; i < n; ++i) {
    const float ru = k.ru[i], rv = k.rv[i], rw = k.rw[i];
    const float iz = k.iz[i];
    const float shrink = s2 / (s2 + ru * ru + rv * rv);
    const float w = shrink * shrink;
    const float far = d2 / (d2 + rw * rw);
    const float wd = k.w[i] > 0.0f ? w * depth_weight * far * far : 0.0f;
    const float fx = camera_fx * iz;
    const float fy = camera_fy * iz;
    const float ux = -fx * k.qx[i] * iz;                // row (fx, 0, ux)
    const float vy = -fy * k.qy[i] * iz;                // row (0, fy, vy)
    const float dz = -iz * iz / (sigma_w + share * iz); // row (0, 0, dz)
    const float n00 = w * fx * fx, n02 = w * fx * ux, n11 = w * fy * fy,
                n12 = w * fy * vy;
    const float n22 = w * (ux * ux + vy * vy) + wd * dz * dz;
    const float h0 = w * ru * fx, h1 = w * rv * fy;
    const float h2 = w * (ru * ux + rv * vy) + wd * rw * dz;
    const float lx = k.lx[i], ly = k.ly[i], lz = k.lz[i];
    // Columns of M crossed with the lever.
    const float e00 = ly * n02, e10 = lz * n00 - lx * n02, e20 = -ly * n00;
    const float e01 = ly * n12 - lz * n11, e11 = -lx * n12, e21 = lx * n11;
    const float e02 = ly * n22 - lz * n12, e12 = lz * n02 - lx * n22,
                e22 = lx * n12 - ly * n02;
    total += w;
    m00 += n00, m02 += n02, m11 += n11, m12 += n12, m22 += n22;
    c00 += e00, c01 += e01, c02 += e02;
    c10 += e10, c11 += e11, c12 += e12;
    c20 += e20, c21 += e21, c22 += e22;
    // Rows of that crossed with the lever.
    a00 += ly * e02 - lz * e01;
    a01 += lz * e00 - lx * e02;
    a02 += lx * e01 - ly * e00;
    a11 += lz * e10 - lx * e12;
    a12 += lx * e11 - ly * e10;
    a22 += lx * e21 - ly * e20;
    t0 += ly * h2 - lz * h1, t1 += lz * h0 - lx * h2, t2 += lx * h1 - ly * h0;
    g0 += h0, g1 += h1, g2 += h2;
  }
  const float a[21] = {a00, a01, a02, c00, c01, c02, a11, a12, c10, c11, c12,
                       a22, c20, c21, c22, m00, 0.f, m02, m11, m12, m22};
  const float b[6] = {t0, t1, t2, g0, g1, g2};
  int at = 0;
  for (int row = 0; row < 6; ++row) {
    e.b[row] += b[row];
    for (int column = row; column < 6; ++column)
      e.a[row][column] += a[at++];
  }
  e.weight += total;
}

bool
FlowFit::step()
{
  const double scale = std::max (options_.tuning.smallest_scale, 2.0 * medianError());
  Equations e;
  forEachBlock ([&] (int, int n, const Block& k) { accumulate (n, k, scale, e); });
  Matrix6 a;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      a (row, column) = a (column, row) = e.a[row][column];
  Vector6 b = Eigen::Map<const Vector6> (e.b);
  const Eigen::Vector3d rotation_vector = vectorFromRotation (rotation_);
  const double prior =
      options_.tuning.rotation_prior * options_.tuning.rotation_prior * count_;
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
  return -b.dot (x) > kSettled * kSettled * e.weight;
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
  const std::vector<float> errors = sampleErrors (samples, count, pose, options);
  double sum = 0.0;
  for (const float error : errors)
    sum += std::min<double> (limit, error);
  return sum / std::max (1, count);
}

std::vector<float>
sampleErrors (const FlowSample* samples,
              int count,
              const RigidPose& pose,
              const RigidFitOptions& options)
{
  FlowFit fit (samples, count, options);
  fit.place (pose);
  std::vector<float> errors (count);
  fit.forEachError ([&] (int i, float error) { errors[i] = error; });
  return errors;
}

} // namespace pcl_msf
