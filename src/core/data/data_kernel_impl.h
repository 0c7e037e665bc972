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

template <typename S>
PCL_MSF_INLINE void
addNormalEquations (int n, const Block<S>& k, Sums& sums)
{
  int at = 0;
  for (int r = 0; r < 6; ++r) {
    S vb[kBlock];
    S vi[kBlock];
    S b = 0;
#pragma omp simd reduction(+ : b)
    for (int i = 0; i < n; ++i) {
      vb[i] = k.wb[i] * k.jb[r][i];
      vi[i] = k.wi[i] * k.ji[r][i];
      b += vb[i] * k.brightness[i] + vi[i] * k.icp[i];
    }
    sums.b[r] += static_cast<double> (b);
    for (int c = r; c < 6; ++c) {
      S a = 0;
#pragma omp simd reduction(+ : a)
      for (int i = 0; i < n; ++i)
        a += vb[i] * k.jb[c][i] + vi[i] * k.ji[c][i];
      sums.a[at++] += static_cast<double> (a);
    }
  }
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
