// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_kernel_residuals.h"

// Robust costs and normal equations of a block of points, and the loop over the blocks.

namespace pcl_msf {
namespace kernel {

/** Eq. 7 with rho (r) = r^2 / 2 inside: q (|r| - q / 2) with q = min (|r|, epsilon). */
template <typename S>
PCL_MSF_INLINE S
robustCost (S r, S huber)
{
  const S magnitude = std::abs (r);
  const S q = smaller (magnitude, huber);
  return q * (magnitude - S (0.5) * q);
}

/** rho' (r) / r. */
template <typename S>
PCL_MSF_INLINE S
robustWeight (S r, S huber)
{
  const S magnitude = larger (S (std::abs (r)), S (1e-6));
  return smaller (magnitude, huber) / magnitude;
}

/** Adds the block's costs. Points whose residual is switched off do not count. */
template <typename S, Mode mode>
PCL_MSF_INLINE void
addCosts (const Points& p,
          int first,
          int n,
          const Rules& rules,
          const Block<S>& k,
          Sums& sums)
{
  const S huber = rules.huber;
  const S limit = mode == Mode::Probe ? S (rules.truncation) : S (1e30);
  S brightness = 0;
  S icp = 0;
  S hidden_brightness = 0;
  S hidden_icp = 0;
#pragma omp simd reduction(+ : brightness, icp, hidden_brightness, hidden_icp)
  for (int i = 0; i < n; ++i) {
    const S cb = smaller (robustCost (k.brightness[i], huber), limit);
    const S ci = smaller (robustCost (k.icp[i], huber), limit);
    const S has_b = mask<S> (p.brightness_scale[first + i] > 0.0f);
    const S has_i = mask<S> (p.icp_scale[first + i] > 0.0f);
    const S on_b = k.brightness_on[i];
    const S on_i = k.icp_on[i];
    brightness += has_b * (on_b * cb + (S (1) - on_b) * k.hidden[i]);
    icp += has_i * (on_i * ci + (S (1) - on_i) * k.hidden[i]);
    hidden_brightness += has_b * (S (1) - on_b);
    hidden_icp += has_i * (S (1) - on_b);
  }
  sums.brightness_cost += static_cast<double> (brightness) * rules.brightness_weight;
  sums.icp_cost += static_cast<double> (icp) * rules.icp_weight;
  sums.hidden += static_cast<double> (hidden_brightness) * rules.brightness_weight +
                 static_cast<double> (hidden_icp) * rules.icp_weight;
}

/** Jacobians by a left perturbation about the motion's origin, and weights. */
template <typename S>
PCL_MSF_INLINE void
differentiate (const Points& p,
               int first,
               int n,
               const Image& image,
               const Motion& m,
               const Rules& rules,
               Block<S>& k)
{
  const S fx = image.fx, fy = image.fy;
  const S ox = m.origin[0], oy = m.origin[1], oz = m.origin[2];
  const S huber = rules.huber;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S mx = k.qx[i] - ox;
    const S my = k.qy[i] - oy;
    const S mz = k.qz[i] - oz;
    const S bx = k.gu[i] * fx * k.iz[i];
    const S by = k.gv[i] * fy * k.iz[i];
    const S bz = -(bx * k.qx[i] + by * k.qy[i]) * k.iz[i];
    k.jb[0][i] = my * bz - mz * by;
    k.jb[1][i] = mz * bx - mx * bz;
    k.jb[2][i] = mx * by - my * bx;
    k.jb[3][i] = bx;
    k.jb[4][i] = by;
    k.jb[5][i] = bz;
    const S s = p.icp_scale[first + i];
    const S nx = k.nx[i] * s;
    const S ny = k.ny[i] * s;
    const S nz = k.nz[i] * s;
    k.ji[0][i] = my * nz - mz * ny;
    k.ji[1][i] = mz * nx - mx * nz;
    k.ji[2][i] = mx * ny - my * nx;
    k.ji[3][i] = nx;
    k.ji[4][i] = ny;
    k.ji[5][i] = nz;
    k.wb[i] = k.brightness_on[i] * robustWeight (k.brightness[i], huber) *
              S (rules.brightness_weight);
    k.wi[i] = k.icp_on[i] * robustWeight (k.icp[i], huber) * S (rules.icp_weight);
  }
}

/** One loop over all 27 sums, which stay in registers as long as there are enough. */
template <typename S>
PCL_MSF_INLINE void
addNormalEquations (int n, const Block<S>& k, Sums& sums)
{
  S a00 = 0, a01 = 0, a02 = 0, a03 = 0, a04 = 0, a05 = 0;
  S a11 = 0, a12 = 0, a13 = 0, a14 = 0, a15 = 0;
  S a22 = 0, a23 = 0, a24 = 0, a25 = 0;
  S a33 = 0, a34 = 0, a35 = 0;
  S a44 = 0, a45 = 0;
  S a55 = 0;
  S b0 = 0, b1 = 0, b2 = 0, b3 = 0, b4 = 0, b5 = 0;
#pragma omp simd reduction(+ : a00, a01, a02, a03, a04, a05, a11, a12, a13, a14, a15, a22, a23, a24, a25, a33, a34, a35, a44, a45, a55, b0, b1, b2, b3, b4, b5)
  for (int i = 0; i < n; ++i) {
    const S wb = k.wb[i], wi = k.wi[i], rb = k.brightness[i], ri = k.icp[i];
    const S p0 = k.jb[0][i], q0 = k.ji[0][i];
    const S p1 = k.jb[1][i], q1 = k.ji[1][i];
    const S p2 = k.jb[2][i], q2 = k.ji[2][i];
    const S p3 = k.jb[3][i], q3 = k.ji[3][i];
    const S p4 = k.jb[4][i], q4 = k.ji[4][i];
    const S p5 = k.jb[5][i], q5 = k.ji[5][i];
    const S v0 = wb * p0, w0 = wi * q0;
    a00 += v0 * p0 + w0 * q0;
    a01 += v0 * p1 + w0 * q1;
    a02 += v0 * p2 + w0 * q2;
    a03 += v0 * p3 + w0 * q3;
    a04 += v0 * p4 + w0 * q4;
    a05 += v0 * p5 + w0 * q5;
    b0 += v0 * rb + w0 * ri;
    const S v1 = wb * p1, w1 = wi * q1;
    a11 += v1 * p1 + w1 * q1;
    a12 += v1 * p2 + w1 * q2;
    a13 += v1 * p3 + w1 * q3;
    a14 += v1 * p4 + w1 * q4;
    a15 += v1 * p5 + w1 * q5;
    b1 += v1 * rb + w1 * ri;
    const S v2 = wb * p2, w2 = wi * q2;
    a22 += v2 * p2 + w2 * q2;
    a23 += v2 * p3 + w2 * q3;
    a24 += v2 * p4 + w2 * q4;
    a25 += v2 * p5 + w2 * q5;
    b2 += v2 * rb + w2 * ri;
    const S v3 = wb * p3, w3 = wi * q3;
    a33 += v3 * p3 + w3 * q3;
    a34 += v3 * p4 + w3 * q4;
    a35 += v3 * p5 + w3 * q5;
    b3 += v3 * rb + w3 * ri;
    const S v4 = wb * p4, w4 = wi * q4;
    a44 += v4 * p4 + w4 * q4;
    a45 += v4 * p5 + w4 * q5;
    b4 += v4 * rb + w4 * ri;
    const S v5 = wb * p5, w5 = wi * q5;
    a55 += v5 * p5 + w5 * q5;
    b5 += v5 * rb + w5 * ri;
  }
  const S a[21] = {a00, a01, a02, a03, a04, a05, a11, a12, a13, a14, a15,
                   a22, a23, a24, a25, a33, a34, a35, a44, a45, a55};
  const S b[6] = {b0, b1, b2, b3, b4, b5};
  for (int j = 0; j < 21; ++j)
    sums.a[j] += static_cast<double> (a[j]);
  for (int j = 0; j < 6; ++j)
    sums.b[j] += static_cast<double> (b[j]);
}

template <typename S, Mode mode>
PCL_MSF_INLINE void
run (const Points& points,
     const Image& image,
     const Motion& motion,
     const Rules& rules,
     const Correspondences& state,
     Sums& sums)
{
  Block<S> k;
  float own_offset[kBlock];
  std::uint8_t own_active[kBlock];
  for (int first = 0; first < points.count; first += kBlock) {
    const int n = std::min (kBlock, points.count - first);
    float* offset = mode == Mode::Probe ? own_offset : state.plane_offset + first;
    std::uint8_t* active = mode == Mode::Probe ? own_active : state.active + first;
    warp (points, first, n, image, motion, k);
    turnNormals (points, first, n, motion, k);
    sampleIntensity (points, first, n, image, k);
    if (mode == Mode::Renew || mode == Mode::Probe)
      correspond (points, first, n, image, k, offset, active);
    planeDistance (points, first, n, offset, active, rules, k);
    addCosts<S, mode> (points, first, n, rules, k, sums);
    if (mode == Mode::Renew || mode == Mode::Keep) {
      differentiate (points, first, n, image, motion, rules, k);
      addNormalEquations (n, k, sums);
    }
  }
}

} // namespace kernel
} // namespace pcl_msf
