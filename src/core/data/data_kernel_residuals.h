// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_kernel.h"

#include <algorithm>
#include <cmath>

// Warped points, residuals and visibility of a block of points. Everything here is
// inlined into the functions of data_kernel.cpp, once per instruction set; each loop
// vectorizes.

#define PCL_MSF_INLINE __attribute__ ((always_inline)) inline

namespace pcl_msf {
namespace kernel {

constexpr int kBlock = 128; // points worked on at a time: stays in the first cache

enum class Mode { Renew, Keep, Cost, Probe };

/** Intermediate values of a block. */
template <typename S>
struct Block {
  S qx[kBlock], qy[kBlock], qz[kBlock], iz[kBlock];
  S nx[kBlock], ny[kBlock], nz[kBlock]; // normals, carried to the current frame
  S u[kBlock], v[kBlock];
  S brightness[kBlock], gu[kBlock], gv[kBlock];
  S icp[kBlock];
  S brightness_on[kBlock], icp_on[kBlock]; // 0 or 1
  S hidden[kBlock];                        // cost of a residual that is off
  S wb[kBlock], wi[kBlock];                // robust weights times term weights
  S jb[6][kBlock], ji[6][kBlock];
};

/** 1 where a condition holds, else 0: keeps the loops free of branches. */
template <typename S>
PCL_MSF_INLINE S
mask (bool condition)
{
  return condition ? S (1) : S (0);
}

template <typename S>
PCL_MSF_INLINE S
smaller (S a, S b)
{
  return a < b ? a : b;
}

template <typename S>
PCL_MSF_INLINE S
larger (S a, S b)
{
  return a > b ? a : b;
}

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
    const S iz = S (1) / larger (qz, S (1e-3));
    k.qx[i] = qx;
    k.qy[i] = qy;
    k.qz[i] = qz;
    k.iz[i] = iz;
    k.u[i] = fx * qx * iz + cx;
    k.v[i] = fy * qy * iz + cy;
  }
}

/** Turns the normals with the frozen rotation. */
template <typename S>
PCL_MSF_INLINE void
turnNormals (const Points& p, int first, int n, const Motion& m, Block<S>& k)
{
  const double* r = m.normal_rotation;
  const S r0 = r[0], r1 = r[1], r2 = r[2], r3 = r[3], r4 = r[4], r5 = r[5];
  const S r6 = r[6], r7 = r[7], r8 = r[8];
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S x = p.nx[first + i];
    const S y = p.ny[first + i];
    const S z = p.nz[first + i];
    k.nx[i] = r0 * x + r1 * y + r2 * z;
    k.ny[i] = r3 * x + r4 * y + r5 * z;
    k.nz[i] = r6 * x + r7 * y + r8 * z;
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
    const S u = smaller (larger (k.u[i], S (0)), last_u);
    const S v = smaller (larger (k.v[i], S (0)), last_v);
    const int u0 = smaller (static_cast<int> (u), image.width - 2);
    const int v0 = smaller (static_cast<int> (v), image.height - 2);
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
    const S in_u = mask<S> (k.u[i] == u) * scale; // the clamped border is flat
    const S in_v = mask<S> (k.v[i] == v) * scale;
    k.brightness[i] = (top + b * (low - top) - S (p.intensity[first + i])) * scale;
    k.gu[i] = ((i10 - i00) + b * ((i11 - i01) - (i10 - i00))) * in_u;
    k.gv[i] = (low - top) * in_v;
  }
}

/** Finds p_corr on the ray of each warped point and decides what is visible. */
template <typename S>
PCL_MSF_INLINE void
correspond (const Points& p,
            int first,
            int n,
            const Image& image,
            Block<S>& k,
            float* plane_offset,
            std::uint8_t* active)
{
  const S last_u = image.width - 1;
  const S last_v = image.height - 1;
  const int row = 2 * image.width;
  const int end_u = image.width - 2;
  const int end_v = image.height - 2;
  const float* const texels = image.texels + 1;
  int bits[kBlock];
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S u = smaller (larger (k.u[i], S (0)), last_u);
    const S v = smaller (larger (k.v[i], S (0)), last_v);
    const int u0 = smaller (static_cast<int> (u), end_u);
    const int v0 = smaller (static_cast<int> (v), end_v);
    const S a = u - static_cast<S> (u0);
    const S b = v - static_cast<S> (v0);
    const int at = v0 * row + 2 * u0;
    const S w00 = texels[at];
    const S w10 = texels[at + 2];
    const S w01 = texels[at + row];
    const S w11 = texels[at + row + 2];
    const S high = larger (larger (w00, w10), larger (w01, w11));
    const S low = smaller (smaller (w00, w10), smaller (w01, w11));
    const S tolerance = p.depth_tolerance[first + i];
    const S top = w00 + a * (w10 - w00);
    const S bottom = w01 + a * (w11 - w01);
    // Bilinear on one surface, the nearest texel where surfaces meet.
    const S right = mask<S> (a >= S (0.5));
    const S lower = mask<S> (b >= S (0.5));
    const S left_value = w00 + lower * (w01 - w00);
    const S right_value = w10 + lower * (w11 - w10);
    const S nearest = left_value + right * (right_value - left_value);
    const S smooth = mask<S> (low > S (0)) * mask<S> (high - low < tolerance);
    const S w = nearest + smooth * (top + b * (bottom - top) - nearest);
    const S inside = mask<S> (k.u[i] >= S (-0.5)) * mask<S> (k.v[i] >= S (-0.5)) *
                     mask<S> (k.u[i] <= last_u + S (0.5)) *
                     mask<S> (k.v[i] <= last_v + S (0.5)) *
                     mask<S> (k.qz[i] > S (1e-3));
    const S behind = w - k.iz[i]; // > 0: the frame shows something nearer
    const S known = mask<S> (w > S (1e-6));
    const S occluded = known * mask<S> (behind > tolerance);
    const S fits = known * mask<S> (behind > S (-3) * tolerance) * (S (1) - occluded);
    const S ray = k.nx[i] * k.qx[i] + k.ny[i] * k.qy[i] + k.nz[i] * k.qz[i];
    plane_offset[i] = static_cast<float> (ray * k.iz[i] / larger (w, S (1e-6)));
    bits[i] = static_cast<int> (inside * (S (kBrightness) * (S (1) - occluded) +
                                          S (kIcp) * fits + S (kOccluded) * occluded +
                                          S (kUnknown) * (S (1) - known)) +
                                S (kOutside) * (S (1) - inside));
  }
#pragma omp simd
  for (int i = 0; i < n; ++i)
    active[i] = static_cast<std::uint8_t> (bits[i]);
}

template <typename S>
PCL_MSF_INLINE void
planeDistance (const Points& p,
               int first,
               int n,
               const float* plane_offset,
               const std::uint8_t* active,
               const Rules& rules,
               Block<S>& k)
{
  const S conflict = rules.conflict_cost;
  const S occluded = S (rules.occluded_cost) - conflict;
  const S outside = S (rules.outside_cost) - conflict;
  const S unknown = S (rules.unknown_cost) - conflict;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const S along = k.nx[i] * k.qx[i] + k.ny[i] * k.qy[i] + k.nz[i] * k.qz[i];
    k.icp[i] = (along - S (plane_offset[i])) * S (p.icp_scale[first + i]);
    const int bits = active[i];
    k.brightness_on[i] = static_cast<S> (bits & 1);
    k.icp_on[i] = static_cast<S> ((bits >> 1) & 1);
    k.hidden[i] = conflict + occluded * static_cast<S> ((bits >> 2) & 1) +
                  outside * static_cast<S> ((bits >> 3) & 1) +
                  unknown * static_cast<S> ((bits >> 4) & 1);
  }
}

} // namespace kernel
} // namespace pcl_msf
