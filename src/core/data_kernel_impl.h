// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data_kernel.h"

#include <algorithm>
#include <cmath>

// Everything here is inlined into the functions of data_kernel.cpp, once per
// instruction set. Each loop runs over a block of points and vectorizes.

#define PCL_MSF_INLINE __attribute__ ((always_inline)) inline

namespace pcl_msf {
namespace kernel {

constexpr int kBlock = 128; // points worked on at a time: stays in the first cache

enum class Mode { Renew, Keep, Cost, Probe };

/** Intermediate values of a block. */
template <typename S>
struct Block {
  S qx[kBlock], qy[kBlock], qz[kBlock], iz[kBlock];
  S u[kBlock], v[kBlock];
  S brightness[kBlock], gu[kBlock], gv[kBlock];
  S icp[kBlock];
  S brightness_on[kBlock], icp_on[kBlock]; // 0 or 1
  S wb[kBlock], wi[kBlock];                // robust weights times term weights
  S jb[6][kBlock], ji[6][kBlock];
};

template <typename S>
PCL_MSF_INLINE void
warp (
    const Points& p, int first, int n, const Image& image, const Motion& m, Block<S>& k)
{
  const S r0 = m.rotation[0], r1 = m.rotation[1], r2 = m.rotation[2];
  const S r3 = m.rotation[3], r4 = m.rotation[4], r5 = m.rotation[5];
  const S r6 = m.rotation[6], r7 = m.rotation[7], r8 = m.rotation[8];
  const S t0 = m.translation[0], t1 = m.translation[1], t2 = m.translation[2];
  const S fx = image.fx, fy = image.fy, cx = image.cx, cy = image.cy;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S x = p.x[first + i];
    const S y = p.y[first + i];
    const S z = p.z[first + i];
    const S qx = r0 * x + r1 * y + r2 * z + t0;
    const S qy = r3 * x + r4 * y + r5 * z + t1;
    const S qz = r6 * x + r7 * y + r8 * z + t2;
    const S iz = S (1) / std::max (qz, S (1e-3));
    k.qx[i] = qx;
    k.qy[i] = qy;
    k.qz[i] = qz;
    k.iz[i] = iz;
    k.u[i] = fx * qx * iz + cx;
    k.v[i] = fy * qy * iz + cy;
  }
}

/** Bilinear intensity, its derivatives, and the brightness residual. */
template <typename S>
PCL_MSF_INLINE void
sampleIntensity (const Points& p, int first, int n, const Image& image, Block<S>& k)
{
  const S last_u = image.width - 1;
  const S last_v = image.height - 1;
  const int row = 2 * image.width;
  const float* const texels = image.texels;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S u = std::min (std::max (k.u[i], S (0)), last_u);
    const S v = std::min (std::max (k.v[i], S (0)), last_v);
    const int u0 = std::min (static_cast<int> (u), image.width - 2);
    const int v0 = std::min (static_cast<int> (v), image.height - 2);
    const S a = u - static_cast<S> (u0);
    const S b = v - static_cast<S> (v0);
    const int at = v0 * row + 2 * u0;
    const S i00 = texels[at];
    const S i10 = texels[at + 2];
    const S i01 = texels[at + row];
    const S i11 = texels[at + row + 2];
    const S top = i00 + a * (i10 - i00);
    const S low = i01 + a * (i11 - i01);
    const S scale = p.brightness_scale[first + i];
    const bool in_u = k.u[i] == u;
    const bool in_v = k.v[i] == v;
    k.brightness[i] = (top + b * (low - top) - S (p.intensity[first + i])) * scale;
    k.gu[i] = in_u ? ((i10 - i00) + b * ((i11 - i01) - (i10 - i00))) * scale : S (0);
    k.gv[i] = in_v ? (low - top) * scale : S (0);
  }
}

/** Finds p_corr on the ray of each warped point and decides what is visible. */
template <typename S>
PCL_MSF_INLINE void
correspond (const Points& p,
            int first,
            int n,
            const Image& image,
            const Rules& rules,
            Block<S>& k,
            float* plane_offset,
            std::uint8_t* active)
{
  const S last_u = image.width - 1;
  const S last_v = image.height - 1;
  const int row = 2 * image.width;
  const float* const texels = image.texels + 1;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S u = std::min (std::max (k.u[i], S (0)), last_u);
    const S v = std::min (std::max (k.v[i], S (0)), last_v);
    const int u0 = std::min (static_cast<int> (u), image.width - 2);
    const int v0 = std::min (static_cast<int> (v), image.height - 2);
    const S a = u - static_cast<S> (u0);
    const S b = v - static_cast<S> (v0);
    const int at = v0 * row + 2 * u0;
    const S w00 = texels[at];
    const S w10 = texels[at + 2];
    const S w01 = texels[at + row];
    const S w11 = texels[at + row + 2];
    const S high = std::max (std::max (w00, w10), std::max (w01, w11));
    const S low = std::min (std::min (w00, w10), std::min (w01, w11));
    const S tolerance = S (rules.depth_tolerance) + S (rules.relative_tolerance) * high;
    const S top = w00 + a * (w10 - w00);
    const S bottom = w01 + a * (w11 - w01);
    const S left = b < S (0.5) ? w00 : w01;
    const S right = b < S (0.5) ? w10 : w11;
    const S nearest = a < S (0.5) ? left : right;
    const bool one_surface = low > S (0) && high - low < tolerance;
    const S w = one_surface ? top + b * (bottom - top) : nearest;
    const bool inside = (k.u[i] >= S (-0.5)) & (k.u[i] <= last_u + S (0.5)) &
                        (k.v[i] >= S (-0.5)) & (k.v[i] <= last_v + S (0.5)) &
                        (k.qz[i] > S (1e-3));
    const S behind = w - k.iz[i]; // > 0: the frame shows something nearer
    const bool known = w > S (0);
    const bool occluded = known & (behind > tolerance);
    const bool fits = known & (behind > S (-3) * tolerance) & !occluded;
    const S ray = S (p.nx[first + i]) * k.qx[i] + S (p.ny[first + i]) * k.qy[i] +
                  S (p.nz[first + i]) * k.qz[i];
    const S inverse_w = S (1) / std::max (w, S (1e-6));
    plane_offset[i] = static_cast<float> (ray * k.iz[i] * inverse_w);
    const int brightness = (inside & !occluded) ? kBrightness : 0;
    const int icp = (inside & fits) ? kIcp : 0;
    const int hidden = (inside & occluded) ? kOccluded : 0;
    const int outside = inside ? 0 : kOutside;
    active[i] = static_cast<std::uint8_t> (brightness | icp | hidden | outside);
  }
}

template <typename S>
PCL_MSF_INLINE void
planeDistance (const Points& p,
               int first,
               int n,
               const float* plane_offset,
               const std::uint8_t* active,
               Block<S>& k)
{
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S along = S (p.nx[first + i]) * k.qx[i] + S (p.ny[first + i]) * k.qy[i] +
                    S (p.nz[first + i]) * k.qz[i];
    k.icp[i] = (along - S (plane_offset[i])) * S (p.icp_scale[first + i]);
    k.brightness_on[i] = (active[i] & kBrightness) ? S (1) : S (0);
    k.icp_on[i] = (active[i] & kIcp) ? S (1) : S (0);
  }
}

/** Eq. 7 with rho (r) = r^2 / 2 inside: cost and weight rho' / r. */
template <typename S>
PCL_MSF_INLINE S
robustCost (S r, S huber)
{
  const S magnitude = std::abs (r);
  const bool quadratic = (huber < S (0)) | (magnitude <= huber);
  return quadratic ? S (0.5) * r * r : huber * (magnitude - S (0.5) * huber);
}

template <typename S>
PCL_MSF_INLINE S
robustWeight (S r, S huber)
{
  const S magnitude = std::max (std::abs (r), S (1e-6));
  const bool quadratic = (huber < S (0)) | (magnitude <= huber);
  return quadratic ? S (1) : huber / magnitude;
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
  const S hidden = rules.hidden_cost;
  const S limit = rules.truncation;
  S brightness = 0;
  S icp = 0;
#pragma omp simd reduction(+ : brightness, icp)
  for (int i = 0; i < n; ++i) {
    S cb = robustCost (k.brightness[i], huber);
    S ci = robustCost (k.icp[i], huber);
    if (mode == Mode::Probe) {
      cb = std::min (cb, limit);
      ci = std::min (ci, limit);
    }
    const S has_b = p.brightness_scale[first + i] > 0.0f ? S (1) : S (0);
    const S has_i = p.icp_scale[first + i] > 0.0f ? S (1) : S (0);
    brightness += has_b * (k.brightness_on[i] > S (0) ? cb : hidden);
    icp += has_i * (k.icp_on[i] > S (0) ? ci : hidden);
  }
  sums.brightness_cost += static_cast<double> (brightness) * rules.brightness_weight;
  sums.icp_cost += static_cast<double> (icp) * rules.icp_weight;
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
    const S nx = S (p.nx[first + i]) * s;
    const S ny = S (p.ny[first + i]) * s;
    const S nz = S (p.nz[first + i]) * s;
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
    sampleIntensity (points, first, n, image, k);
    if (mode == Mode::Renew || mode == Mode::Probe)
      correspond (points, first, n, image, rules, k, offset, active);
    planeDistance (points, first, n, offset, active, k);
    addCosts<S, mode> (points, first, n, rules, k, sums);
    if (mode == Mode::Renew || mode == Mode::Keep) {
      differentiate (points, first, n, image, motion, rules, k);
      addNormalEquations (n, k, sums);
    }
  }
}

} // namespace kernel
} // namespace pcl_msf
